// The subjects of a study on one grid: each is mapped once, and its result is kept in files that a study that continues
// takes over.
#pragma once

#include <string>
#include <vector>

#include "correspondence/study/subject.h"
#include "session/session.h"
#include "studies/study_list.h"

namespace orbicube::cli {

struct MappedSubject {
  std::size_t number = 0;  // in the list
  base::Array<mesh::Vector3> positions;
  Json figures;         // the same for every run
  Json functions{};     // of the first subject, which the others are aligned with: coefficients, or null
  bool reused = false;  // taken from a study before
  double seconds = 0;   // for a subject that was not
};

struct FailedSubject {
  std::size_t number = 0;
  std::string kind, text;
};

struct StudySubjects {
  std::vector<MappedSubject> mapped;  // in the order of the list
  std::vector<FailedSubject> failed;
};

// Whether another attempt with the same input and options fails as well, by the kind of the error.
bool fails_again(const std::string& kind);

// Which subjects a process maps: all; those up to the first that can be mapped; these and some others; or none, but
// takes what the folder has.
enum class Mapped { all, first, some, kept };

struct SubjectWork {
  Mapped which = Mapped::all;
  std::vector<std::size_t> some;  // numbers in the list, ascending
};

// Repairs and maps each subject, of an image the surface of its label (0: the only one), and carries the grid to it:
// FOLDER/NAME.ply has its positions and FOLDER/NAME.json its figures, with hashes of the input, the options and the
// positions and the digest of the machine, or FOLDER/NAME.json has why it cannot be mapped. The first subject that can
// be mapped is what the others are aligned with. As many subjects at a time as there are threads; the same bits for any
// number, and for processes that share the work in one folder. A subject that fails does not end the study. Throws
// Failure "no-valid-result" where there are fewer than two of all or no first one, "unsupported" where a machine that
// rounds otherwise (rounding.h) has mapped the first one that some others are to follow, or one of a group,
// "out-of-memory" where processes could differ about the first one, and "cancelled".
StudySubjects map_subjects(const std::vector<StudySubject>& list, const SubjectWork& work,
                           const std::filesystem::path& folder, const correspondence::SubjectOptions& options,
                           std::int32_t label, const CommonOptions& common, Session& session);

}  // namespace orbicube::cli
