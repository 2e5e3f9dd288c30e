// Triangles that patches must not intersect.
#pragma once

#include <cstddef>
#include <span>

#include "mesh/search/bounding_volume_tree.h"
#include "repair/types.h"

namespace orbicube::repair {

// A search among chosen triangles of a surface, which must outlive it and keep its numbers of vertices.
class Obstacles {
 public:
  // chosen[t] is 0 for triangles that are no obstacles. O(n log n). Throws Error "cancelled".
  Obstacles(std::span<const Vector3> positions, std::span<const Triangle> triangles,
            std::span<const std::uint8_t> chosen, const base::Host& host);

  // Returns whether the triangle, of vertices of the surface, has no area or intersects an obstacle besides the
  // vertices and the edge that they share. Exact.
  bool meet(const Triangle& triangle) const;

 private:
  std::span<const Vector3> positions_;
  Array<Triangle> triangles_;
  Array<mesh::Box> boxes_;
  mesh::BoundingVolumeTree tree_;
};

}  // namespace orbicube::repair
