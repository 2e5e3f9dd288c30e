#include "studies/study_part.h"

#include <algorithm>

#include "base/counted.h"
#include "session/mistakes.h"

namespace orbicube::cli {
namespace {

std::size_t number_of(const std::string& name, const std::vector<StudySubject>& list, const std::string& input) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const StudySubject& s) { return s.name == name; });
  if (found != list.end()) return static_cast<std::size_t>(found - list.begin());
  std::vector<std::string> names;
  for (const StudySubject& subject : list)
    names.push_back(subject.name);
  std::string text = "--subjects: no subject is called '" + name + "'";
  const std::vector<std::string> nearest = nearest_words(name, names);
  if (!nearest.empty()) text += "; did you mean '" + nearest.front() + "'?";
  throw Failure(Exit::wrong_input, input, "invalid-argument", text + "; --stage list prints all names");
}

}  // namespace

void add_part_options(CLI::App& verb, StudyPart& part) {
  verb.add_option("--stage", part.stage,
                  "part of the study, for several processes with one FOLDER: list, print the names of the subjects; "
                  "first, map the one that the others are aligned with; subjects, map subjects; group, the rest, from "
                  "the subjects that are mapped [default: all]")
      ->check(unnamed(CLI::IsMember({"all", "list", "first", "subjects", "group"})))
      ->type_name("PART");
  verb.add_option("--subjects", part.subjects, "names of the subjects that --stage subjects maps [default: all]")
      ->type_name("NAME...");
}

SubjectWork work_of(const StudyPart& part, const std::vector<StudySubject>& list, const std::string& input) {
  SubjectWork work;
  if (part.stage == "first") work.which = Mapped::first;
  if (part.stage == "group") work.which = Mapped::kept;
  if (part.subjects.empty()) return work;
  work.which = Mapped::some;
  for (const std::string& name : part.subjects)
    work.some.push_back(number_of(name, list, input));
  std::sort(work.some.begin(), work.some.end());
  work.some.erase(std::unique(work.some.begin(), work.some.end()), work.some.end());
  return work;
}

void say_list(const std::vector<StudySubject>& list, Session& session) {
  Json& figure = session.figures()["list"] = Json::array();
  for (const StudySubject& subject : list) {
    figure.push_back({{"name", subject.name}, {"file", subject.file.string()}});
    session.say(subject.name);
  }
}

void add_subject_figures(const std::vector<StudySubject>& list, const StudySubjects& subjects, Session& session) {
  Json& figures = session.figures();
  figures["subjects"] = Json::array();
  std::size_t reused = 0;
  for (const MappedSubject& subject : subjects.mapped) {
    const StudySubject& listed = list[subject.number];
    Json entry = {{"name", listed.name}, {"file", listed.file.string()}, {"reused", subject.reused}};
    if (!subject.reused) entry["seconds"] = subject.seconds;
    entry.update(subject.figures);
    figures["subjects"].push_back(entry);
    reused += subject.reused ? 1 : 0;
  }
  figures["failed"] = Json::array();
  for (const FailedSubject& failed : subjects.failed) {
    const StudySubject& listed = list[failed.number];
    figures["failed"].push_back(
        {{"name", listed.name}, {"file", listed.file.string()}, {"kind", failed.kind}, {"message", failed.text}});
  }
  figures["reused"] = reused;
}

void note_failed(const std::vector<StudySubject>& list, const StudySubjects& subjects, Session& session) {
  for (const FailedSubject& failed : subjects.failed)
    session.note(list[failed.number].file.string() + ": left out: " + failed.kind + ": " + failed.text);
}

void say_subjects(const std::vector<StudySubject>& list, const StudySubjects& subjects, const std::string& output,
                  Session& session) {
  note_failed(list, subjects, session);
  const auto reused = session.figures()["reused"].get<std::size_t>();
  session.say("wrote " + output + "/subjects: " + base::counted(subjects.mapped.size(), "subject") +
              (reused > 0 ? ", " + std::to_string(reused) + " of them taken from the study before" : ""));
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

void require_lasting_results(const std::vector<StudySubject>& list, const SubjectWork& work,
                             const StudySubjects& subjects) {
  if (work.which == Mapped::first) return;
  for (const FailedSubject& failed : subjects.failed) {
    // Others are those before the first one.
    const bool wanted =
        work.which == Mapped::all || std::binary_search(work.some.begin(), work.some.end(), failed.number);
    if (wanted && !fails_again(failed.kind))
      throw Failure(Exit::no_result, list[failed.number].file.string(), failed.kind, failed.text);
  }
}

}  // namespace orbicube::cli
