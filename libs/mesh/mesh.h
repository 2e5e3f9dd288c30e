// The mesh that readers make and writers take: positions and flat arrays of cells, with the numbers of their regions.
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

// Numbers of the regions that triangles and cells belong to, as patches and materials of a model: of each kind one
// number for each, or none at all. 0: no region.
struct Regions {
  explicit Regions(std::pmr::memory_resource* memory) : triangles(memory), tetrahedra(memory), hexahedra(memory) {}

  Array<std::int32_t> triangles;
  Array<std::int32_t> tetrahedra;
  Array<std::int32_t> hexahedra;

  bool empty() const { return triangles.empty() && tetrahedra.empty() && hexahedra.empty(); }
};

struct Mesh {
  explicit Mesh(std::pmr::memory_resource* memory = std::pmr::get_default_resource())
      : positions(memory), triangles(memory), tetrahedra(memory), hexahedra(memory), regions(memory) {}

  Array<Vector3> positions;
  Array<Triangle> triangles;  // of a surface, or the boundary triangles that a volume file lists
  Array<Tetrahedron> tetrahedra;
  Array<Hexahedron> hexahedra;
  Regions regions;
};

}  // namespace orbicube::mesh
