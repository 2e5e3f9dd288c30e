// The header of a PLY file: which elements follow, and of which properties each is made.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/files/text_scanner.h"

namespace orbicube::mesh {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type;  // of a list
};

struct PlyElement {
  std::string name;
  std::uint64_t count;
  std::vector<PlyProperty> properties;

  // Place of the property of one of the names, if there is one.
  std::optional<std::size_t> find(std::initializer_list<std::string_view> names) const;
  // The fewest bytes that one takes in a binary file.
  std::size_t min_size() const;
};

enum class PlyForm { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyForm form;
  std::vector<PlyElement> elements;
};

// Reads the header, up to and with the end of the end_header line. Throws Error "bad-magic", "truncated", "parse".
PlyHeader read_ply_header(TextScanner& scanner);

}  // namespace orbicube::mesh
