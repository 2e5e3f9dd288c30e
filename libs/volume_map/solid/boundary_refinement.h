// Tetrahedra of a solid cut where a polycube map has cut the triangles of its surface.
#pragma once

#include "polycube/surface/surface_map.h"
#include "volume_map/types.h"

namespace orbicube::volume_map {

struct RefinedSolid {
  explicit RefinedSolid(std::pmr::memory_resource* memory) : positions(memory), tetrahedra(memory) {}

  Array<Vector3> positions;  // the map's, then those inside
  Array<Tetrahedron> tetrahedra;
};

// `positions` begin with the vertices of the surface that `map` was made of, whose triangles `triangles` are the
// boundary of the tetrahedra. First every tetrahedron gets a vertex, an edge or a face in common with the boundary and
// no more (freeing_splits.h); then the parts of an edge or face make the parts of its tetrahedra. Throws Error
// "no-valid-result" when a part is not positive by exact signs, "invalid-argument" when the boundary is another,
// "cancelled". O(n log n).
RefinedSolid refine_boundary(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                             std::span<const mesh::Triangle> triangles, const polycube::SurfaceMap& map,
                             const base::Host& host);

}  // namespace orbicube::volume_map
