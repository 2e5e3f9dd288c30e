// Reads numbers and signs from the text of a file of coefficients and says in which line something is wrong.
#pragma once

#include <fast_float/fast_float.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/error.h"

namespace orbicube::harmonics {

class FieldScanner {
 public:
  explicit FieldScanner(std::span<const std::byte> bytes)
      : begin_(reinterpret_cast<const char*>(bytes.data())), at_(begin_), end_(begin_ + bytes.size()) {
    if (bytes.empty()) throw base::Error("empty-file", "the file is empty");
    const char* nul = std::find(begin_, end_, '\0');
    if (nul == end_) return;
    at_ = nul;
    fail("parse", "a NUL byte, which no text file has");
  }

  bool at_end() const { return at_ == end_; }
  // Past blanks and line ends.
  void skip_space() {
    while (at_ != end_ && (is_blank(*at_) || *at_ == '\n'))
      ++at_;
  }
  // Past blanks of this line and at most one comma.
  void skip_separator() {
    skip_blanks();
    if (at_ != end_ && *at_ == ',') ++at_;
    skip_blanks();
  }
  bool at_end_of_line() {
    skip_blanks();
    return at_ == end_ || *at_ == '\n';
  }
  void next_line() {
    at_ = std::find(at_, end_, '\n');
    if (at_ != end_) ++at_;
  }
  bool starts_with(char c) const { return at_ != end_ && *at_ == c; }

  // The sign `c`, after space.
  void expect(char c) {
    skip_space();
    if (at_ == end_) fail("truncated", std::string("the file ends where '") + c + "' was expected");
    if (*at_ != c) fail("parse", "expected '" + std::string(1, c) + "', found " + found());
    ++at_;
  }

  // A whole number at this place, if there is one: digits that no other part of a number follows.
  std::optional<std::uint64_t> whole_number() {
    std::uint64_t value = 0;
    const auto [stop, problem] = std::from_chars(at_, end_, value);
    if (problem != std::errc() || !ends_field(stop)) return std::nullopt;
    at_ = stop;
    return value;
  }

  double number(const char* what) {
    if (at_ == end_) fail("truncated", std::string("the file ends where ") + what + " was expected");
    const char* start = *at_ == '+' && at_ + 1 != end_ && at_[1] != '-' ? at_ + 1 : at_;
    double value = 0;
    auto [stop, problem] = fast_float::from_chars(start, end_, value);
    if (problem == std::errc() && stop != end_ && (*stop == 'D' || *stop == 'd')) {
      // Fortran's exponent.
      std::string text(start, std::find_if(start, end_, [](char c) { return ends_field_with(c); }));
      text[static_cast<std::size_t>(stop - start)] = 'e';
      const auto again = fast_float::from_chars(text.data(), text.data() + text.size(), value);
      stop = start + (again.ptr - text.data());
    }
    if (problem == std::errc::invalid_argument || !ends_field(stop))
      fail("parse", std::string(what) + " expected, found " + found());
    if (!std::isfinite(value)) fail("non-finite", std::string(what) + " is " + found());
    at_ = stop;
    return value;
  }

  [[noreturn]] void fail(const char* kind, const std::string& text) const {
    throw base::Error(kind, "line " + std::to_string(1 + std::count(begin_, at_, '\n')) + ": " + text);
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  static bool ends_field_with(char c) { return is_blank(c) || c == '\n' || c == ',' || c == '}'; }
  bool ends_field(const char* place) const { return place == end_ || ends_field_with(*place); }
  void skip_blanks() {
    while (at_ != end_ && is_blank(*at_))
      ++at_;
  }
  std::string found() const {
    constexpr std::ptrdiff_t longest = 40;
    const char* stop = std::find_if(at_, end_, [](char c) { return ends_field_with(c); });
    if (stop == at_) return at_ == end_ ? "the end of the file" : std::string("'") + (*at_ == '\n' ? ' ' : *at_) + "'";
    std::string text = "'";
    for (const char* c = at_; c != stop && c - at_ < longest; ++c)
      text += *c >= ' ' && *c <= '~' ? *c : '?';
    return text + (stop - at_ > longest ? "...'" : "'");
  }

  const char* begin_;
  const char* at_;
  const char* end_;
};

}  // namespace orbicube::harmonics
