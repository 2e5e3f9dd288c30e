// A surface of fewer triangles, on vertices of the fine one.
#pragma once

#include <span>

#include "volume_map/types.h"

namespace orbicube::volume_map {

struct CoarseSurface {
  explicit CoarseSurface(std::pmr::memory_resource* memory) : positions(memory), triangles(memory) {}

  Array<Vector3> positions;
  Array<mesh::Triangle> triangles;
};

// Of about the given number of triangles (polycube/surface/decimation.h), without vertices in no triangle; all of the
// surface when that has no more. It may meet itself where the fine one nearly does. The surface must be a closed
// oriented manifold. O(n log n).
CoarseSurface coarse_surface(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                             std::size_t target, const base::Host& host);

// How many triangles the surface of `all` gets that is mapped or filled: `triangles` where it has more than twice as
// many; all of them otherwise, and with 0.
inline std::size_t coarse_target(std::size_t triangles, std::size_t all) {
  return triangles > 0 && all > 2 * triangles ? triangles : all;
}

}  // namespace orbicube::volume_map
