// The part of a study that one process does: many of them, also on many machines that share a folder, do it together.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "session/session.h"
#include "studies/study_list.h"
#include "studies/study_subjects.h"

namespace orbicube::cli {

struct StudyPart {
  std::string stage = "all";          // list, first, subjects, group, all
  std::vector<std::string> subjects;  // names, of stage subjects; empty: all
};

void add_part_options(CLI::App& verb, StudyPart& part);

// Returns the subjects that the part maps. Throws Failure "invalid-argument" for a name that no subject has.
SubjectWork work_of(const StudyPart& part, const std::vector<StudySubject>& list, const std::string& input);

// Says the names of the subjects, and adds the figure "list".
void say_list(const std::vector<StudySubject>& list, Session& session);

// Adds the figures "subjects", "failed" and "reused" of subjects alone, without those of the group.
void add_subject_figures(const std::vector<StudySubject>& list, const StudySubjects& subjects, Session& session);

// Says how many subjects of a part have been mapped, and notes those that cannot be.
void say_subjects(const std::vector<StudySubject>& list, const StudySubjects& subjects, const std::string& output,
                  Session& session);
void note_failed(const std::vector<StudySubject>& list, const StudySubjects& subjects, Session& session);

// Throws Failure about a subject that the part maps and that failed by what may be otherwise next time, as a lack of
// memory.
void require_lasting_results(const std::vector<StudySubject>& list, const SubjectWork& work,
                             const StudySubjects& subjects);

}  // namespace orbicube::cli
