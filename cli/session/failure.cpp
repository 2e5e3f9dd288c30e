#include "session/failure.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace orbicube::cli {
namespace {

// Kinds that are nobody's fault: neither the input nor the command line is wrong.
constexpr std::array<std::string_view, 5> without_result = {"no-valid-result", "out-of-memory", "cancelled",
                                                            "time-limit", "internal"};

}  // namespace

std::string printable(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return (c < ' ' && c != '\n') || c == '\x7f'; }, ' ');
  return text;
}

std::string Failure::line() const {
  std::string all = printable((file_.empty() ? "" : file_ + ": ") + kind_ + ": " + what());
  std::replace(all.begin(), all.end(), '\n', ' ');
  return all;
}

Failure failure_of(const base::Error& error, const std::filesystem::path& file, Role role) {
  const std::string_view kind = error.kind();
  const bool work_failed = std::find(without_result.begin(), without_result.end(), kind) != without_result.end() ||
                           (role == Role::output && kind == "io");
  return {work_failed ? Exit::no_result : Exit::wrong_input, file.string(), error.kind(), error.what()};
}

Failure out_of_memory(const std::filesystem::path& file) {
  return {Exit::no_result, file.string(), "out-of-memory", "there is not enough memory"};
}

}  // namespace orbicube::cli
