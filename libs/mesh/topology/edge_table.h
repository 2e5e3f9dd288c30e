// The half-edges of a triangle mesh grouped by the edge that they lie on, whatever the mesh: what everything that
// queries how triangles hang together starts from.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// Half-edge 3 t + k goes from corner k of triangle t to the next corner.
inline Index triangle_of(Index half_edge) {
  return half_edge / 3;
}
inline Index next_in_triangle(Index half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}
inline Index start_of(std::span<const Triangle> triangles, Index half_edge) {
  return triangles[half_edge / 3][half_edge % 3];
}
inline Index end_of(std::span<const Triangle> triangles, Index half_edge) {
  return start_of(triangles, next_in_triangle(half_edge));
}

// Whether a corner is repeated: such triangles have no part in any edge.
inline bool has_repeated_corner(const Triangle& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

// O(n) time for bounded valence and O(n log n) for any, 28 bytes a triangle kept and as much again while it is made.
class EdgeTable {
 public:
  // Triangle indices must be below vertex_count. Throws Error "unsupported" for 2^32 / 3 triangles or more,
  // "cancelled".
  EdgeTable(std::size_t vertex_count, std::span<const Triangle> triangles, const base::Host& host);

  std::size_t size() const { return edge_begin_.size() - 1; }
  // Of one edge, in ascending order. Edges are in ascending order of their lower vertex, then of their higher one.
  std::span<const Index> half_edges(std::size_t edge) const {
    return {half_edges_.data() + edge_begin_[edge], edge_begin_[edge + 1] - edge_begin_[edge]};
  }

 private:
  Array<Index> half_edges_;
  Array<Index> edge_begin_;
};

}  // namespace orbicube::mesh
