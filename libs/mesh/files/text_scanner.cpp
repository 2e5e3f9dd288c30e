#include "mesh/files/text_scanner.h"

#include <fast_float/fast_float.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "base/counted.h"
#include "base/error.h"

namespace orbicube::mesh {

std::string in_quotes(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text(1, '\'');
  for (const char c : word.substr(0, longest))
    text += c >= ' ' && c <= '~' ? c : '?';
  text += word.size() > longest ? "...'" : "'";
  return text;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view space = " \t\r\n\v\f";
  const std::size_t begin = std::min(text.find_first_not_of(space), text.size());
  const std::size_t end = text.find_last_not_of(space);
  return text.substr(begin, end == std::string_view::npos ? 0 : end + 1 - begin);
}

std::string in_small_letters(std::string_view word) {
  std::string text(word);
  for (char& c : text)
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  return text;
}

TextScanner::TextScanner(std::span<const std::byte> bytes, char comment, const base::Host& host)
    : begin_(reinterpret_cast<const char*>(bytes.data())),
      at_(begin_),
      end_(begin_ + bytes.size()),
      comment_(comment),
      host_(host) {
  if (bytes.empty()) return;
  if (const void* nul = std::memchr(begin_, 0, bytes.size())) {
    at_ = static_cast<const char*>(nul);
    fail("parse", "a NUL byte, which no text file has");
  }
  if (std::memchr(begin_, '\n', bytes.size()) == nullptr) line_end_ = '\r';
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (std::string_view(begin_, bytes.size()).starts_with(byte_order_mark)) at_ += byte_order_mark.size();
}

void TextScanner::skip_blanks() {
  for (;;) {
    while (at_ != end_ && is_blank(*at_))
      ++at_;
    if (!continued_ || at_ == end_ || *at_ != '\\') return;
    const char* next = at_ + 1;
    while (next != end_ && is_blank(*next))
      ++next;
    if (next == end_ || *next != line_end_) return;
    at_ = next + 1;
  }
}

bool TextScanner::at_end_of_line() {
  skip_blanks();
  return at_ == end_ || *at_ == line_end_ || *at_ == comment_;
}

void TextScanner::next_line() {
  for (;;) {
    const void* found = std::memchr(at_, line_end_, static_cast<std::size_t>(end_ - at_));
    const char* line_end = found ? static_cast<const char*>(found) : end_;
    const char* last = line_end;
    while (last != at_ && is_blank(last[-1]))
      --last;
    const bool goes_on = continued_ && line_end != end_ && last != at_ && last[-1] == '\\';
    at_ = line_end == end_ ? end_ : line_end + 1;
    if (!goes_on) return;
  }
}

std::string_view TextScanner::word() {
  if (at_end_of_line()) return {};
  return rest_of_word();
}

std::string_view TextScanner::rest_of_word() {
  const char* start = at_;
  while (at_ != end_ && !is_space(*at_))
    ++at_;
  return {start, static_cast<std::size_t>(at_ - start)};
}

bool TextScanner::skip_space() {
  for (;;) {
    while (at_ != end_ && is_space(*at_))
      ++at_;
    if (at_ == end_) return false;
    if (comment_ == 0 || *at_ != comment_) return true;
    next_line();
  }
}

std::string_view TextScanner::word_after_space() {
  skip_space();
  return word();
}

std::string TextScanner::found() const {
  const char* stop = at_;
  while (stop != end_ && !is_space(*stop))
    ++stop;
  return stop == at_ ? "the end of the line" : in_quotes({at_, static_cast<std::size_t>(stop - at_)});
}

void TextScanner::require_more(const char* what) {
  skip_blanks();
  if (at_ == end_) fail("truncated", std::string("the file ends where ") + what + " was expected");
}

Vector3 TextScanner::point_after_space() {
  Vector3 point;
  for (double& x : point) {
    skip_space();
    x = coordinate("a coordinate");
  }
  return point;
}

const char* TextScanner::real(const char* start, double& value) const {
  const auto [stop, problem] = fast_float::from_chars(start, end_, value);
  if (problem == std::errc::invalid_argument) return nullptr;
  if (ends_number(stop)) return stop;
  // 1.5D+03 of Fortran.
  if (*stop != 'D' && *stop != 'd') return nullptr;
  const char* last = stop;
  while (!ends_number(last))
    ++last;
  std::string text(start, last);
  text[static_cast<std::size_t>(stop - start)] = 'e';
  const char* const end_of_text = text.data() + text.size();
  const auto [end, wrong] = fast_float::from_chars(text.data(), end_of_text, value);
  return wrong != std::errc::invalid_argument && end == end_of_text ? last : nullptr;
}

const char* TextScanner::whole_number(const char* start, std::int64_t& value) const {
  constexpr double exact = 9007199254740992;  // 2^53
  double x = 0;
  const char* const stop = real(start, x);
  if (stop == nullptr || !(std::abs(x) < exact) || x != std::trunc(x)) return nullptr;
  value = static_cast<std::int64_t>(x);
  return stop;
}

double TextScanner::coordinate(const char* what) {
  require_more(what);
  const char* start = at_;
  if (*start == '+' && start + 1 != end_ && start[1] != '-') ++start;
  double value = 0;
  const char* const stop = real(start, value);
  if (stop == nullptr) fail("parse", std::string(what) + " expected, found " + found());
  if (!std::isfinite(value)) fail("non-finite", std::string(what) + " is " + found());
  at_ = stop;
  return value;
}

std::int64_t TextScanner::integer(const char* what, const char* too_large) {
  require_more(what);
  const char* start = at_ + (*at_ == '+' && at_ + 1 != end_ && at_[1] != '-');
  std::int64_t value = 0;
  auto [stop, problem] = std::from_chars(start, end_, value);
  if (problem == std::errc::result_out_of_range) fail(too_large, std::string(what) + " is out of range: " + found());
  if (problem == std::errc() && !ends_number(stop)) stop = whole_number(start, value);
  if (problem != std::errc() || stop == nullptr) fail("parse", std::string(what) + " expected, found " + found());
  at_ = stop;
  return value;
}

void TextScanner::skip_word(const char* what) {
  if (!skip_space()) fail("truncated", std::string("the file ends where ") + what + " was expected");
  rest_of_word();
}

std::uint64_t TextScanner::count(const char* what) {
  const std::int64_t value = integer(what);
  if (value < 0) fail("parse", std::string(what) + " is negative: " + std::to_string(value));
  return static_cast<std::uint64_t>(value);
}

std::int64_t TextScanner::any_index() {
  require_more("a vertex index");
  std::int64_t value = 0;
  const auto [stop, problem] = std::from_chars(at_, end_, value);
  if (problem == std::errc::result_out_of_range) fail("index-range", "vertex index " + found() + " is out of range");
  if (problem != std::errc()) fail("parse", "a vertex index expected, found " + found());
  at_ = stop;
  return value;
}

Index TextScanner::index(std::int64_t first, std::size_t limit) {
  require_more("a vertex index");
  const char* start = at_;
  std::int64_t value = any_index();
  if (!ends_number(at_)) {
    const char* const stop = whole_number(start, value);
    at_ = stop == nullptr ? start : stop;
    if (stop == nullptr) fail("parse", "a vertex index expected, found " + found());
  }
  if (value < first || static_cast<std::uint64_t>(value - first) >= limit) {
    at_ = start;
    fail("index-range", "vertex index " + std::to_string(value) + " of " + base::counted(limit, "vertex", "vertices") +
                            ", which are counted from " + std::to_string(first));
  }
  return static_cast<Index>(value - first);
}

void TextScanner::require_room(std::uint64_t items, std::size_t bytes_each, const char* what) const {
  const auto room = static_cast<std::uint64_t>(end_ - at_) + 1;  // the last line needs no end
  if (items > room / bytes_each) {
    fail("truncated", "the file says that it has " + std::to_string(items) + " " + what + ", but only " +
                          base::counted(end_ - at_, "byte follows", "bytes follow"));
  }
}

std::size_t TextScanner::line_of(const char* place) const {
  return 1 + static_cast<std::size_t>(std::count(begin_, place, line_end_));
}

void TextScanner::fail(const char* kind, const std::string& what) const {
  throw base::Error(kind, "line " + std::to_string(line_of(at_)) + ": " + what);
}

void TextScanner::report() const {
  host_.report("reading", static_cast<std::uint64_t>(at_ - begin_), static_cast<std::uint64_t>(end_ - begin_));
}

}  // namespace orbicube::mesh
