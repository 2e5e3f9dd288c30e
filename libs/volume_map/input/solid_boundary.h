// A mesh of tetrahedra with the vertices of its boundary first, as maps of solids want it.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::volume_map {

struct BoundaryFirst {
  explicit BoundaryFirst(std::pmr::memory_resource* memory) : positions(memory), tetrahedra(memory), surface(memory) {}

  std::span<const mesh::Vector3> outer_positions() const { return std::span(positions).first(outer); }

  base::Array<mesh::Vector3> positions;
  base::Array<mesh::Tetrahedron> tetrahedra;
  base::Array<mesh::Triangle> surface;  // outward-oriented
  std::size_t outer = 0;                // vertices of the boundary
};

// Vertices that no tetrahedron has are left out. Throws Error for cells that fill no solid (mesh/topology/cells.h),
// "not-connected" for several pieces, with the place, "cancelled". Walls of cavities are part of the surface and look
// into these.
BoundaryFirst boundary_first(const mesh::Mesh& solid, const base::Host& host);

}  // namespace orbicube::volume_map
