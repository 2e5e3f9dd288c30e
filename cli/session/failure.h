// Why the command failed: the file, the kind word, the text and the exit code.
#pragma once

#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>

#include "base/error.h"

namespace orbicube::cli {

enum class Exit : int {
  done = 0,
  no_result = 1,    // the work failed: no valid result, stopped, out of memory, the disk is full
  wrong_input = 2,  // the input or the command line is wrong
};

// Returns the text with a blank for each control character but the ends of lines: names of files may have any, which
// terminals obey.
std::string printable(std::string text);

class Failure : public std::runtime_error {
 public:
  // `file` may be empty, and is then left out of the message.
  Failure(Exit exit_code, std::string file, std::string kind, const std::string& text)
      : std::runtime_error(text), exit_code_(exit_code), file_(std::move(file)), kind_(std::move(kind)) {}

  Exit exit_code() const { return exit_code_; }
  const std::string& file() const { return file_; }
  const std::string& kind() const { return kind_; }

  // FILE: KIND: text, on one line.
  std::string line() const;

 private:
  Exit exit_code_;
  std::string file_;
  std::string kind_;
};

// What is being done with a file while an error appears.
enum class Role { input, output };

// The failure that an error about a file is.
Failure failure_of(const base::Error& error, const std::filesystem::path& file, Role role);
Failure out_of_memory(const std::filesystem::path& file);

// Does `work`; errors in it are failures about `file`.
template <class Work>
auto about(const std::filesystem::path& file, Role role, const Work& work) {
  try {
    return work();
  } catch (const base::Error& error) {
    throw failure_of(error, file, role);
  } catch (const std::bad_alloc&) {
    throw out_of_memory(file);
  } catch (const std::length_error&) {
    throw out_of_memory(file);
  }
}

}  // namespace orbicube::cli
