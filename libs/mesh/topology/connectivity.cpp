#include "mesh/topology/connectivity.h"

#include <string>

#include "base/error.h"

namespace orbicube::mesh {

Connectivity::Connectivity(std::size_t vertex_count, std::span<const Triangle> triangles, const base::Host& host)
    : triangles_(triangles),
      opposite_(3 * triangles.size(), no_index, host.memory),
      outgoing_(vertex_count, no_index, host.memory) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (has_repeated_corner(triangles[t]))
      throw base::Error("degenerate-face", "face " + std::to_string(t) + " has a repeated vertex");
  }
  {
    const EdgeTable edges(vertex_count, triangles, host);
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (e % base::items_between_reports == 0) host.report("joining half-edges", e, edges.size());
      const auto h = edges.half_edges(e);
      if (h.size() == 1) continue;
      const auto place = [&] { return "edge " + std::to_string(start(h[0])) + "-" + std::to_string(end(h[0])); };
      if (h.size() > 2) throw base::Error("non-manifold-edge", place() + " has more than two faces");
      if (start(h[0]) == start(h[1])) {
        throw base::Error("inconsistent-orientation", place() + " lies between faces of opposite orientations");
      }
      opposite_[h[0]] = h[1];
      opposite_[h[1]] = h[0];
    }
  }
  Array<Index> faces_at(vertex_count, 0, host.memory);
  for (Index h = 0; h < opposite_.size(); ++h) {
    const Index v = start(h);
    ++faces_at[v];
    if (outgoing_[v] == no_index || opposite_[h] == no_index) outgoing_[v] = h;
  }
  // A fan that does not have all the faces of its vertex is not the only one.
  for (Index v = 0; v < vertex_count; ++v) {
    if (v % base::items_between_reports == 0) host.report("walking round vertices", v, vertex_count);
    Index seen = 0;
    for_each_outgoing(v, [&](Index) { ++seen; });
    if (seen != faces_at[v]) {
      throw base::Error("non-manifold-vertex", "vertex " + std::to_string(v) + " joins parts that share no edge");
    }
  }
}

}  // namespace orbicube::mesh
