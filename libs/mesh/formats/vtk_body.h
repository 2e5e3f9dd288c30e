// The numbers and words of a legacy VTK file, in its ASCII and in its binary form.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/files/binary_scanner.h"
#include "mesh/files/text_scanner.h"

namespace orbicube::mesh {

enum class VtkNumber { int8, uint8, int16, uint16, int32, uint32, int64, float32, float64 };

inline std::optional<VtkNumber> number_named(std::string_view word) {
  struct Name {
    std::string_view word;
    VtkNumber number;
  };
  static constexpr Name names[] = {{"char", VtkNumber::int8},       {"unsigned_char", VtkNumber::uint8},
                                   {"short", VtkNumber::int16},     {"unsigned_short", VtkNumber::uint16},
                                   {"int", VtkNumber::int32},       {"unsigned_int", VtkNumber::uint32},
                                   {"vtkidtype", VtkNumber::int32}, {"vtktypeint64", VtkNumber::int64},
                                   {"long", VtkNumber::int64},      {"float", VtkNumber::float32},
                                   {"double", VtkNumber::float64}};
  const std::string small = in_small_letters(word);
  for (const Name& name : names) {
    if (name.word == small) return name.number;
  }
  return std::nullopt;
}

inline std::size_t size_of(VtkNumber number) {
  switch (number) {
    case VtkNumber::int8:
    case VtkNumber::uint8:
      return 1;
    case VtkNumber::int16:
    case VtkNumber::uint16:
      return 2;
    case VtkNumber::int32:
    case VtkNumber::uint32:
    case VtkNumber::float32:
      return 4;
    case VtkNumber::int64:
    case VtkNumber::float64:
      break;
  }
  return 8;
}

inline std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  constexpr std::string_view blanks = " \t\r\v\f";
  for (std::size_t at = line.find_first_not_of(blanks); at < line.size();) {
    const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = std::min(line.find_first_not_of(blanks, end), line.size());
  }
  return words;
}

inline std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// ASCII and binary files differ in how numbers are stored; both bodies support the same queries.
class VtkTextBody {
 public:
  explicit VtkTextBody(TextScanner& scanner) : scanner_(scanner) {}
  // The words of the next line that has any; none at the end of the file.
  std::vector<std::string_view> words() {
    std::vector<std::string_view> result;
    if (!scanner_.skip_space()) return result;
    while (!scanner_.at_end_of_line())
      result.push_back(scanner_.word());
    return result;
  }
  void skip_to_empty_line() {
    scanner_.next_line();
    while (!scanner_.at_end_of_file() && !scanner_.at_end_of_line())
      scanner_.next_line();
  }
  void require_room(std::uint64_t items, VtkNumber, const char* what) { scanner_.require_room(items, 2, what); }
  double number(VtkNumber) { return scanner_.skip_space(), scanner_.coordinate("a number"); }
  std::int64_t integer(VtkNumber) { return scanner_.skip_space(), scanner_.integer("an integer"); }
  std::string_view rest() const { return text_of(scanner_.rest()); }
  void skip(std::size_t bytes) { scanner_.skip_bytes(bytes); }
  void progress() { scanner_.progress(); }
  [[noreturn]] void fail(const char* kind, const std::string& what) const { scanner_.fail(kind, what); }

 private:
  TextScanner& scanner_;
};

class VtkBinaryBody {
 public:
  explicit VtkBinaryBody(BinaryScanner& scanner) : scanner_(scanner) {}
  std::vector<std::string_view> words() {
    while (scanner_.left() > 0) {
      auto result = words_of(scanner_.line());
      if (!result.empty()) return result;
    }
    return {};
  }
  void skip_to_empty_line() {
    while (scanner_.left() > 0 && !words_of(scanner_.line()).empty())
      scanner_.progress();
  }
  void require_room(std::uint64_t items, VtkNumber type, const char* what) {
    scanner_.require_room(items, size_of(type), what);
  }
  double number(VtkNumber type) {
    if (type == VtkNumber::float32) return static_cast<double>(scanner_.next<float>());
    if (type == VtkNumber::float64) return scanner_.next<double>();
    return static_cast<double>(integer(type));
  }
  std::int64_t integer(VtkNumber type) {
    switch (type) {
      case VtkNumber::int8:
        return scanner_.next<std::int8_t>();
      case VtkNumber::uint8:
        return scanner_.next<std::uint8_t>();
      case VtkNumber::int16:
        return scanner_.next<std::int16_t>();
      case VtkNumber::uint16:
        return scanner_.next<std::uint16_t>();
      case VtkNumber::int32:
        return scanner_.next<std::int32_t>();
      case VtkNumber::uint32:
        return scanner_.next<std::uint32_t>();
      case VtkNumber::int64:
        return scanner_.next<std::int64_t>();
      case VtkNumber::float32:
      case VtkNumber::float64:
        break;
    }
    fail("parse", "an array of integers has a type of real numbers");
  }
  std::string_view rest() const { return text_of(scanner_.rest()); }
  void skip(std::size_t bytes) { scanner_.skip(bytes); }
  void progress() { scanner_.progress(); }
  [[noreturn]] void fail(const char* kind, const std::string& what) const { scanner_.fail(kind, what); }

 private:
  BinaryScanner& scanner_;
};

}  // namespace orbicube::mesh
