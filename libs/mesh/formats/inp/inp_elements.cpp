#include "mesh/formats/inp/inp_elements.h"

#include <algorithm>
#include <array>

namespace orbicube::mesh {
namespace {

// The families whose name goes on with the number of nodes.
constexpr std::array solids = {"C3D", "DC3D", "AC3D", "F3D", "COH3D"};
constexpr std::array faces = {"S",    "STRI", "DS",   "CPS",  "CPE", "CPEG", "CAX",  "DC2D",
                              "AC2D", "DCAX", "ACAX", "CGAX", "M3D", "R3D",  "SFM3D"};
constexpr std::array lines = {"T2D", "T3D", "R2D", "RAX", "RB3D"};
constexpr std::array others = {"MASS",    "ROTARYI", "SPRING", "DASHPOT", "CONN",  "GAP", "DCOUP", "JOINT",
                               "HEATCAP", "ITS",     "PIPE",   "ELBOW",   "FRAME", "SAX", "MAX"};

// Returns the number behind the name of the family, as 8 of "C3D8R" for "C3D".
std::optional<std::size_t> nodes_after(std::string_view type, std::string_view family) {
  if (!type.starts_with(family)) return std::nullopt;
  type.remove_prefix(family.size());
  std::size_t nodes = 0, digits = 0;
  while (digits < type.size() && digits < 3 && type[digits] >= '0' && type[digits] <= '9')
    nodes = 10 * nodes + static_cast<std::size_t>(type[digits++] - '0');
  if (digits == 0) return std::nullopt;
  return nodes;
}

template <std::size_t n>
std::optional<std::size_t> nodes_in(const std::array<const char*, n>& families, std::string_view type) {
  for (const char* family : families) {
    if (const auto nodes = nodes_after(type, family)) return nodes;
  }
  return std::nullopt;
}

}  // namespace

std::size_t nodes_of(InpShape shape) {
  switch (shape) {
    case InpShape::passed_over:
      return 0;
    case InpShape::line:
      return 2;
    case InpShape::triangle:
      return 3;
    case InpShape::quadrilateral:
    case InpShape::tetrahedron:
      return 4;
    case InpShape::pyramid:
      return 5;
    case InpShape::prism:
      return 6;
    case InpShape::hexahedron:
      return 8;
  }
  return 0;
}

std::optional<InpShape> inp_shape(std::string_view type) {
  if (const auto nodes = nodes_in(solids, type)) {
    const bool cohesive = type.starts_with("COH");
    if (*nodes == 4 && !cohesive) return InpShape::tetrahedron;
    if (*nodes == 5 && !cohesive) return InpShape::pyramid;
    if (*nodes == 6) return InpShape::prism;
    if (*nodes == 8) return InpShape::hexahedron;
    return std::nullopt;
  }
  if (type.starts_with("STRI65")) return std::nullopt;
  if (const auto nodes = nodes_in(faces, type)) {
    if (*nodes == 3) return InpShape::triangle;
    if (*nodes == 4) return InpShape::quadrilateral;
    return std::nullopt;
  }
  if (type.starts_with("SC6") || type.starts_with("SC8"))  // continuum shells
    return type[2] == '6' ? InpShape::prism : InpShape::hexahedron;
  // The digits of beams are their dimension and order: B31 and B21 are straight.
  if (type.starts_with("B31") || type.starts_with("B21") || type.starts_with("B33") || type.starts_with("B23"))
    return InpShape::line;
  if (type.starts_with("B32") || type.starts_with("B22")) return InpShape::passed_over;
  if (const auto nodes = nodes_in(lines, type)) return *nodes == 2 ? InpShape::line : InpShape::passed_over;
  const bool passed_over =
      type == "D" || std::ranges::any_of(others, [&](const char* other) { return type.starts_with(other); });
  return passed_over ? std::optional(InpShape::passed_over) : std::nullopt;
}

}  // namespace orbicube::mesh
