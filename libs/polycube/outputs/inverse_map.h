// Where points of a polycube are on the surface: the inverse of a certified map, triangle by exact signs.
#pragma once

#include <span>

#include "base/host.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

struct LocatedPoints {
  explicit LocatedPoints(std::pmr::memory_resource* memory) : triangles(memory), weights(memory) {}

  Array<Index> triangles;  // of the map, that has the point; no_index for points that are on no triangle
  Array<Vector3> weights;  // at its corners, none negative, sum 1
};

// Points must lie in planes of patches exactly; they may be in any order. Where a point is in several triangles, which
// only happens on their borders, one of them is returned. O(n log n). Throws Error "cancelled".
LocatedPoints locate(const SurfaceMap& map, std::span<const Vector3> points, const base::Host& host);

// The point of the surface.
inline Vector3 interpolate(const SurfaceMap& map, Index triangle, const Vector3& weights) {
  const Triangle& t = map.triangles[triangle];
  return weights[0] * map.positions[t[0]] + weights[1] * map.positions[t[1]] + weights[2] * map.positions[t[2]];
}

}  // namespace orbicube::polycube
