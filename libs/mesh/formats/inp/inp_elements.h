// The types of elements of Abaqus and CalculiX that are read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace orbicube::mesh {

enum class InpShape : std::uint8_t {
  passed_over,
  line,
  triangle,
  quadrilateral,
  tetrahedron,
  pyramid,
  prism,
  hexahedron
};

// Returns the number of nodes of a shape; 0 for elements that are passed over, which have any number.
std::size_t nodes_of(InpShape shape);

// Returns the shape of the elements of a type in capital letters, as "C3D8R" or "CPS4"; nothing for types that are not
// read, such as curved ones. Point-like elements, springs and the like are passed over.
std::optional<InpShape> inp_shape(std::string_view type);

}  // namespace orbicube::mesh
