// Text with numbers, collected in large pieces on the way to a file.
#pragma once

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/host.h"
#include "mesh/files/file.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

class TextWriter {
 public:
  // `total` items are going to be written, for progress.
  TextWriter(OutputFile& file, std::uint64_t total, const base::Host& host) : file_(file), total_(total), host_(host) {
    buffer_.reserve(piece + longest_number);
  }

  TextWriter& operator<<(std::string_view text) {
    buffer_ += text;
    return *this;
  }
  TextWriter& operator<<(char c) {
    buffer_ += c;
    return *this;
  }
  // The shortest text that reads as the same double: at most 17 digits.
  TextWriter& operator<<(double x) { return number(x); }
  TextWriter& operator<<(std::uint64_t x) { return number(x); }
  TextWriter& operator<<(Index x) { return number(x); }
  TextWriter& operator<<(std::int32_t x) { return number(x); }

  // Call after each item.
  void end_item() {
    if (++done_ % 1024 != 0) return;
    host_.report("writing", done_, total_);
    if (buffer_.size() >= piece) flush();
  }
  // Call at the end.
  void flush() {
    file_.write(buffer_);
    buffer_.clear();
  }

 private:
  static constexpr std::size_t piece = std::size_t{1} << 20U;
  static constexpr std::size_t longest_number = 32;

  template <class Number>
  TextWriter& number(Number x) {
    char text[longest_number];
    const char* end = std::to_chars(text, text + longest_number, x).ptr;
    buffer_.append(text, static_cast<std::size_t>(end - text));
    return *this;
  }

  OutputFile& file_;
  std::uint64_t total_;
  const base::Host& host_;
  std::string buffer_;
  std::uint64_t done_ = 0;
};

}  // namespace orbicube::mesh
