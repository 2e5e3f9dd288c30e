// The mesh that readers make and writers take: positions and flat arrays of cells, nothing else.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "base/array.h"

namespace orbicube::mesh {

using base::Array;
using Vector3 = Eigen::Vector3d;
using Index = std::uint32_t;
using Triangle = std::array<Index, 3>;
// The first three counter-clockwise seen from the fourth's far side: volume > 0.
using Tetrahedron = std::array<Index, 4>;
// MEDIT and VTK order: bottom face counter-clockwise from inside, then top.
using Hexahedron = std::array<Index, 8>;

inline constexpr Index no_index = ~Index{0};

struct Mesh {
  explicit Mesh(std::pmr::memory_resource* memory = std::pmr::get_default_resource())
      : positions(memory), triangles(memory), tetrahedra(memory), hexahedra(memory) {}

  Array<Vector3> positions;
  Array<Triangle> triangles;  // of a surface, or the boundary triangles that a volume file lists
  Array<Tetrahedron> tetrahedra;
  Array<Hexahedron> hexahedra;
};

}  // namespace orbicube::mesh
