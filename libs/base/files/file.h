// Files: read at once, and written so that an error, a full disk or a kill leaves what was there before.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "base/array.h"
#include "base/files/descriptor.h"
#include "base/host.h"

namespace orbicube::base {

enum class Links { follow, refuse };

// All bytes of a file. Throws Error "io", also for what is no file (a folder, a pipe, a device), and "cancelled". With
// Links::refuse, for names that come from a file, a link or what is no file is "unsafe-path".
Array<std::byte> read_file(const std::filesystem::path& path, const Host& host, Links links = Links::follow);

// A file that is written whole or not at all: to a temporary file beside it (temporary_name.h), which takes its name
// once every byte is on the disk.
class OutputFile {
 public:
  // Starts the file that is to be at `path` (a link is followed), and removes what killed programs left of it. A path
  // that is there and is no regular file, as a pipe or a terminal, is written to as it is. Throws Error "io", as the
  // other functions do, when that fails; the message says what failed and why, not the path, which the caller knows.
  explicit OutputFile(const std::filesystem::path& path);
  // Without commit, leaves the old file and removes the new one.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  // Appends. One call of the system each: give it large pieces.
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);

  // Puts the new file in the place of the old one.
  void commit();

 private:
  void create();
  [[noreturn]] void fail(const char* what) const;

  Descriptor folder_;      // where it goes, without links
  std::string name_;       // there
  std::string temporary_;  // empty when written to directly
  Descriptor file_;
};

}  // namespace orbicube::base
