// The files that one run of a verb writes: all of them replace their targets at the end, or none does.
//
// Each is written into a folder of its own beside its place, which nobody else may enter and whose name nobody can know
// before (base/files/temporary_name.h), and may be read and checked there. Then all are renamed, which takes no time to
// speak of. Where one cannot be, those before get their old content back.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/files/descriptor.h"

namespace orbicube::cli {

class Outputs {
 public:
  Outputs() = default;
  // Without commit, removes what was written.
  ~Outputs() { discard(); }
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  // Where to write the file that is to be at `target` (a link is followed): a path with the same name and ending.
  // Removes what a killed run to the same place has left; see leftovers(). Throws Failure "io", and "usage" when the
  // place is that of another output already.
  std::filesystem::path stage(const std::filesystem::path& target);

  // Moves all files to their targets; what is no regular file, as a pipe or a device, gets the bytes. Throws Failure
  // "io" about the file that could not be put there; then all places have what they had, but for pipes and devices.
  void commit();
  // Forgets all, and removes it.
  void discard();

  // Names of what was removed.
  const std::vector<std::string>& leftovers() const { return leftovers_; }

 private:
  struct Output {
    std::filesystem::path given;                // as the user calls it
    std::filesystem::path target;               // without links
    std::filesystem::path folder;               // of the temporary file
    base::Descriptor lock;                      // on it, until the file is in its place
    std::optional<std::filesystem::path> kept;  // the old file, where there is one and it can be kept
    bool copied = false;                        // rather than renamed
    bool existed = false;
    mode_t mode = 0;  // of the old file

    // The format goes by the ending that the user gave; a link may have another than what it leads to.
    std::filesystem::path file() const { return folder / given.filename(); }
  };

  static void make_folder(Output& output);
  static void copy(const Output& output);
  static void rename(Output& output);
  static void undo(const Output& output);

  std::vector<Output> all_;
  std::vector<std::string> leftovers_;
};

}  // namespace orbicube::cli
