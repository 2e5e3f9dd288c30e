// Half-edges of an oriented manifold surface on two flat arrays: the opposite of each half-edge, and one half-edge out
// of each vertex, from which its neighbors are walked round.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"
#include "mesh/topology/circulate.h"
#include "mesh/topology/edge_table.h"

namespace orbicube::mesh {

// Half-edge 3 t + k goes from corner k of triangle t to the next (edge_table.h). 12 bytes a triangle and 4 a vertex.
class Connectivity {
 public:
  // Keeps a view of `triangles`, whose indices must be below vertex_count. Throws Error "degenerate-face",
  // "non-manifold-edge", "inconsistent-orientation" or "non-manifold-vertex" with the place, "cancelled". A boundary is
  // fine. O(n) for bounded valence.
  Connectivity(std::size_t vertex_count, std::span<const Triangle> triangles, const base::Host& host);

  Index start(Index half_edge) const { return start_of(triangles_, half_edge); }
  Index end(Index half_edge) const { return end_of(triangles_, half_edge); }
  static Index next(Index half_edge) { return next_in_triangle(half_edge); }
  static Index previous(Index half_edge) { return half_edge % 3 == 0 ? half_edge + 2 : half_edge - 1; }
  // On the same edge in the neighboring triangle, the other way; no_index on the boundary.
  Index opposite(Index half_edge) const { return opposite_[half_edge]; }
  // One that starts at the vertex: at the boundary the one without an opposite, no_index for a vertex in no triangle.
  Index outgoing(Index vertex) const { return outgoing_[vertex]; }
  bool on_boundary(Index vertex) const {
    return outgoing_[vertex] != no_index && opposite_[outgoing_[vertex]] == no_index;
  }

  // visit(half_edge) for each half-edge that starts at the vertex, one a triangle, counter-clockwise seen from outside.
  template <class Visit>
  void for_each_outgoing(Index vertex, const Visit& visit) const {
    circulate(
        outgoing_[vertex], [&](Index h) { return opposite_[previous(h)]; }, visit);
  }

  // visit(neighbor) for each vertex that an edge joins with `vertex`, counter-clockwise.
  template <class Visit>
  void for_each_neighbor(Index vertex, const Visit& visit) const {
    Index last = no_index;
    for_each_outgoing(vertex, [&](Index h) {
      visit(end(h));
      last = h;
    });
    if (last != no_index && opposite_[previous(last)] == no_index) visit(start(previous(last)));
  }

 private:
  std::span<const Triangle> triangles_;
  Array<Index> opposite_;
  Array<Index> outgoing_;
};

}  // namespace orbicube::mesh
