#include "mesh/formats/ply_header.h"

#include <algorithm>

#include "base/error.h"

namespace orbicube::mesh {
namespace {

std::optional<PlyType> type_named(std::string_view word) {
  struct Name {
    std::string_view word;
    PlyType type;
  };
  static constexpr Name names[] = {
      {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
      {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
      {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
      {"float64", PlyType::float64}};
  for (const Name& name : names) {
    if (name.word == word) return name.type;
  }
  return std::nullopt;
}

PlyType read_type(TextScanner& scanner) {
  const std::string_view word = scanner.word();
  const auto type = type_named(in_small_letters(word));
  if (!type) scanner.fail("parse", in_quotes(word) + " is no type of a PLY property");
  return *type;
}

PlyForm read_form(TextScanner& scanner) {
  const std::string word = in_small_letters(scanner.word());
  if (word == "ascii") return PlyForm::ascii;
  if (word == "binary_little_endian") return PlyForm::little_endian;
  if (word == "binary_big_endian") return PlyForm::big_endian;
  scanner.fail("parse", in_quotes(word) + " is no PLY format");
}

PlyProperty read_property(TextScanner& scanner) {
  PlyProperty property{};
  if (scanner.starts_with_ignoring_case("list")) {
    scanner.word();
    property.count_type = read_type(scanner);
    if (property.count_type == PlyType::float32 || property.count_type == PlyType::float64) {
      scanner.fail("parse", "the length of a list is no integer");
    }
  }
  property.type = read_type(scanner);
  property.name = in_small_letters(scanner.word());
  if (property.name.empty()) scanner.fail("parse", "a property without a name");
  return property;
}

}  // namespace

std::size_t size_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      break;
  }
  return 8;
}

std::optional<std::size_t> PlyElement::find(std::initializer_list<std::string_view> names) const {
  for (std::size_t i = 0; i < properties.size(); ++i) {
    if (std::find(names.begin(), names.end(), properties[i].name) != names.end()) return i;
  }
  return std::nullopt;
}

std::size_t PlyElement::min_size() const {
  std::size_t size = 0;
  for (const PlyProperty& p : properties)
    size += size_of(p.count_type.value_or(p.type));
  return size;
}

PlyHeader read_ply_header(TextScanner& scanner) {
  if (in_small_letters(scanner.word()) != "ply") throw base::Error("bad-magic", "line 1: a PLY file starts with ply");
  const auto rest = scanner.rest();
  const std::string_view text(reinterpret_cast<const char*>(rest.data()), rest.size());
  if (text.find("end_header") == std::string_view::npos && text.find("END_HEADER") == std::string_view::npos) {
    throw base::Error("truncated", "the header has no end_header");
  }
  PlyHeader header{};
  bool has_form = false;
  for (;;) {
    scanner.next_line();
    if (scanner.at_end_of_file()) scanner.fail("truncated", "the file ends before the line end_header");
    const std::string keyword = in_small_letters(scanner.word());
    if (keyword == "end_header") break;
    if (keyword == "format") {
      header.form = read_form(scanner);
      has_form = true;
    } else if (keyword == "element") {
      const std::string_view name = scanner.word();
      header.elements.push_back({in_small_letters(name), scanner.count("the number of elements"), {}});
    } else if (keyword == "property") {
      if (header.elements.empty()) scanner.fail("parse", "a property before any element");
      header.elements.back().properties.push_back(read_property(scanner));
    } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
      scanner.fail("parse", in_quotes(keyword) + " has no meaning in a PLY header");
    }
  }
  if (!has_form) scanner.fail("parse", "the header has no format line");
  scanner.next_line();
  return header;
}

}  // namespace orbicube::mesh
