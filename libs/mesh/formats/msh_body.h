// The numbers and sections of a Gmsh file, in its text and in its binary form.
#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "mesh/files/binary_scanner.h"
#include "mesh/files/text_scanner.h"

namespace orbicube::mesh {

// Text of either version.
class MshText {
 public:
  MshText(std::span<const std::byte> bytes, const base::Host& host) : scanner_(bytes, 0, host) {}

  // The next line that is not empty; nothing at the end of the file.
  std::string_view line() {
    if (!scanner_.skip_space()) return {};
    const char* const begin = scanner_.place();
    const char* end = begin;
    while (!scanner_.at_end_of_line()) {
      scanner_.word();
      end = scanner_.place();
    }
    return {begin, static_cast<std::size_t>(end - begin)};
  }
  // The numbers of a section begin: how many items the text says that there are.
  std::uint64_t item_count() { return size("the number of items"); }

  std::int64_t integer(const char* what) {
    scanner_.skip_space();
    return scanner_.integer(what);
  }
  std::uint64_t size(const char* what) {
    scanner_.skip_space();
    return scanner_.count(what);
  }
  // The number of a node or cell.
  std::uint64_t number(const char* what) { return size(what); }
  double coordinate() {
    scanner_.skip_space();
    return scanner_.coordinate("a coordinate");
  }
  // A parameter on a curve, surface or volume, which is passed over.
  void skip_parameter() {
    scanner_.skip_space();
    scanner_.skip_word("a parameter");
  }
  // Items of at least that number of numbers, each of two characters or more.
  void require_room(std::uint64_t items, std::size_t numbers_each, std::size_t /*bytes_each*/, const char* what) const {
    scanner_.require_room(items, 2 * numbers_each, what);
  }
  [[noreturn]] void fail(const char* kind, const std::string& what) const { scanner_.fail(kind, what); }
  void progress() { scanner_.progress(); }

 private:
  TextScanner scanner_;
};

// Binary files of version 2, with numbers of 32 bits behind counts in text, or of version 4, with sizes of 64 bits.
class MshBinary {
 public:
  // `bytes` begin at `offset` in the file, behind the section MeshFormat.
  MshBinary(std::span<const std::byte> bytes, std::size_t offset, std::endian order, bool version_4,
            const base::Host& host)
      : scanner_(bytes, offset, order, host), version_4_(version_4) {}

  std::string_view line() {
    while (scanner_.left() > 0) {
      std::string_view text = scanner_.line();
      while (text.ends_with('\r') || text.ends_with(' '))
        text.remove_suffix(1);
      if (!text.empty()) return text;
    }
    return {};
  }
  std::uint64_t item_count() {
    if (version_4_) return size("the number of items");
    const std::string_view text = line();
    std::uint64_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (text.empty() || error != std::errc() || end != text.data() + text.size())
      scanner_.fail("parse", "the number of items expected, found " + in_quotes(text.substr(0, 40)));
    return count;
  }

  std::int64_t integer(const char* what) { return next<std::int32_t>(what); }
  std::uint64_t size(const char* what) { return next<std::uint64_t>(what); }
  std::uint64_t number(const char* what) {
    if (version_4_) return size(what);
    const std::int64_t value = integer(what);
    if (value < 0) scanner_.fail("index-range", std::string(what) + " is " + std::to_string(value));
    return static_cast<std::uint64_t>(value);
  }
  double coordinate() {
    const double value = next<double>("a coordinate");
    if (!std::isfinite(value)) scanner_.fail("non-finite", "a coordinate is not a finite number");
    return value;
  }
  void skip_parameter() { next<double>("a parameter"); }
  void require_room(std::uint64_t items, std::size_t /*numbers_each*/, std::size_t bytes_each, const char* what) const {
    scanner_.require_room(items, bytes_each, what);
  }
  // Past what a section holds, whose end is a line of its own.
  void skip_to(std::string_view end) {
    const std::string_view rest(reinterpret_cast<const char*>(scanner_.rest().data()), scanner_.left());
    const std::size_t at = rest.find(end);
    if (at == std::string_view::npos) scanner_.fail("truncated", "the file ends before " + std::string(end));
    scanner_.skip(at);
  }
  [[noreturn]] void fail(const char* kind, const std::string& what) const { scanner_.fail(kind, what); }
  void progress() { scanner_.progress(); }

 private:
  template <class Number>
  Number next(const char* what) {
    scanner_.require(sizeof(Number), what);
    return scanner_.next<Number>();
  }

  BinaryScanner scanner_;
  bool version_4_;
};

}  // namespace orbicube::mesh
