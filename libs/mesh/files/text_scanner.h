// Reads numbers and words from the bytes of a text file, whatever the locale, and says in which line something is
// wrong.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// A word of a file as messages show it: in quotes, shortened, without what terminals would not print.
std::string in_quotes(std::string_view word);

// The text without blanks and ends of lines around it.
std::string_view trimmed(std::string_view text);

// The same word in small letters, of ASCII, whatever the locale.
std::string in_small_letters(std::string_view word);

class TextScanner {
 public:
  // Lines end with LF, CRLF, or CR where there is no LF. `comment` starts a comment that ends with the line, 0 for
  // none. A byte order mark is passed over. Throws Error "parse" when there is a NUL: no text file has one.
  TextScanner(std::span<const std::byte> bytes, char comment, const base::Host& host);

  // Lines. A backslash at the end of a line continues it where `continued` was requested.
  void continue_lines_with_backslash() { continued_ = true; }
  bool at_end_of_file() const { return at_ == end_; }
  bool at_end_of_line();  // after blanks; comments count as the end
  void next_line();       // to the start of the next one, whatever is left of this one
  // The next word of this line, up to a blank or the end; empty at the end of the line.
  std::string_view word();
  // All that is left of this line, whatever it is, without its end; not past it.
  std::string_view line() const {
    const auto left = static_cast<std::size_t>(end_ - at_);
    return std::string_view(at_, left).substr(0, std::string_view(at_, left).find(line_end_));
  }
  // What goes on without a blank where the last number ended.
  std::string_view rest_of_word();

  // Whether this line goes on, after blanks, with `text`. Moves past the blanks only.
  bool starts_with(std::string_view text) {
    skip_blanks();
    return std::string_view(at_, static_cast<std::size_t>(end_ - at_)).starts_with(text);
  }

  // The same whatever the size of the letters; `text` is in small ones.
  bool starts_with_ignoring_case(std::string_view text) {
    skip_blanks();
    return in_small_letters({at_, std::min(text.size(), static_cast<std::size_t>(end_ - at_))}) == text;
  }

  // Words and numbers wherever the lines end.
  bool skip_space();  // false at the end of the file
  std::string_view word_after_space();
  // Whether a letter is next, as opposed to a number; not at the end of the file.
  bool at_letter() const { return (*at_ >= 'A' && *at_ <= 'Z') || (*at_ >= 'a' && *at_ <= 'z'); }

  // Three coordinates, likewise.
  Vector3 point_after_space();

  // A number at the place reached, in this line (after blanks), with Fortran's exponents too. Throws "parse", naming
  // `what` was expected and what was found, "truncated" where the file ends there, "non-finite" for what is no finite
  // number.
  double coordinate(const char* what);
  // Also one that is written as a real number. `too_large` is the kind of error for what 64 bits do not hold.
  std::int64_t integer(const char* what, const char* too_large = "parse");
  // Past a word wherever it stands, whatever it is; "truncated" where the file ends.
  void skip_word(const char* what);
  // An integer of 0 or more; "parse" otherwise.
  std::uint64_t count(const char* what);
  // A vertex index between `first` and first + limit - 1, less `first`; "index-range" otherwise.
  Index index(std::int64_t first, std::size_t limit);
  // An index of any sign and size that 64 bits hold; beyond them "index-range".
  std::int64_t any_index();

  // Throws "truncated" unless what is left of the file can hold `items` things of at least `bytes_each`.
  void require_room(std::uint64_t items, std::size_t bytes_each, const char* what) const;

  // What is left, for binary blocks, and how to go on behind them.
  std::span<const std::byte> rest() const { return std::as_bytes(std::span(at_, end_)); }
  void skip_bytes(std::size_t count) { at_ += count; }

  [[noreturn]] void fail(const char* kind, const std::string& what) const;
  // The place reached, and the line, from 1, that a place is in; that counts lines, so it is for messages only.
  const char* place() const { return at_; }
  std::size_t line_of(const char* place) const;

  // Reports to the host how far the file is read. Call once a line or item: most calls cost an addition.
  void progress() {
    if (++calls_ % 1024 == 0) report();
  }

 private:
  bool is_blank(char c) const {
    return c == ' ' || c == '\t' || c == '\v' || c == '\f' || (c == '\r' && line_end_ != '\r');
  }
  bool is_space(char c) const { return is_blank(c) || c == line_end_ || c == '\r' || c == '\n'; }
  void skip_blanks();
  bool ends_number(const char* stop) const {
    return stop == end_ || is_space(*stop) || (comment_ != 0 && *stop == comment_);
  }
  // Where the number ends that begins at `start` and has a blank behind it; nullptr where there is none.
  const char* real(const char* start, double& value) const;
  const char* whole_number(const char* start, std::int64_t& value) const;
  void report() const;
  std::string found() const;
  void require_more(const char* what);

  const char* begin_;
  const char* at_;
  const char* end_;
  char comment_;
  char line_end_ = '\n';
  bool continued_ = false;
  std::uint64_t calls_ = 0;
  const base::Host& host_;
};

}  // namespace orbicube::mesh
