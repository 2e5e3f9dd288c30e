// An output that is looked at again before it takes its name: written beside its place, checked, renamed.
#pragma once

#include <filesystem>
#include <string>

namespace orbicube::cli {

class CheckedFile {
 public:
  // For the file that is to be at `path`; a link is followed.
  explicit CheckedFile(const std::filesystem::path& path);
  // Without commit, removes what was written.
  ~CheckedFile();
  CheckedFile(const CheckedFile&) = delete;
  CheckedFile& operator=(const CheckedFile&) = delete;

  // Where to write to and to read from: a path with the same ending, so the same format.
  const std::filesystem::path& path() const { return temporary_; }

  // Puts the file in its place; a place that is no regular file, as a pipe, gets the bytes. Throws Error "io".
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path temporary_;
  bool copied_;  // rather than renamed
};

}  // namespace orbicube::cli
