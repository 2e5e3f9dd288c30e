// The cross field that an aligned frame field leaves on the boundary, and its singular vertices: by the theorem of
// Poincare and Hopf their indices add up to the Euler characteristic of the boundary (Ray, Vallet, Li, Levy 2008).
#pragma once

#include <cstdint>
#include <span>

#include "base/host.h"
#include "frame_field/graph/dual_graph.h"

namespace orbicube::frame_field {

struct BoundaryIndices {
  explicit BoundaryIndices(std::pmr::memory_resource* memory) : quarters(memory) {}

  Array<std::int32_t> quarters;  // by vertex of the mesh: four times the index, 0 for regular and inner ones
  std::int64_t sum_of_quarters = 0;
  std::int64_t euler_characteristic = 0;  // vertices - edges + faces of the boundary
  std::size_t singular_vertices = 0;
};

// Each boundary face counts with the frame of its tetrahedron, turned as little as possible to the face's normal. O(n).
// Throws Error "cancelled".
BoundaryIndices boundary_indices(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                                 std::span<const Quaternion> field, const base::Host& host);

}  // namespace orbicube::frame_field
