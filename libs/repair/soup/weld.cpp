#include "repair/soup/weld.h"

#include <algorithm>
#include <span>

#include "mesh/search/nearest.h"
#include "mesh/topology/edge_table.h"
#include "mesh/topology/weld.h"
#include "repair/soup/soup.h"

namespace orbicube::repair {
namespace {

// Vertices of edges with an odd number of faces, ascending.
Array<Index> open_vertices(const Soup& soup, const base::Host& host) {
  Array<std::uint8_t> open(soup.positions.size(), 0, host.memory);
  const mesh::EdgeTable edges(soup.positions.size(), soup.triangles, host);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto h = edges.half_edges(e);
    if (h.size() % 2 == 0) continue;
    open[mesh::start_of(soup.triangles, h[0])] = 1;
    open[mesh::end_of(soup.triangles, h[0])] = 1;
  }
  Array<Index> vertices(host.memory);
  for (Index v = 0; v < open.size(); ++v) {
    if (open[v] != 0) vertices.push_back(v);
  }
  return vertices;
}

// For each point the number of the one that it is welded to, or its own.
Array<Index> representatives(std::span<const Vector3> points, double distance, const base::Host& host) {
  if (!(distance > 0)) return mesh::first_at_same_position(points, host);
  const mesh::VertexSearch search(points, host);
  Array<Index> to(points.size(), no_index, host.memory);
  for (Index i = 0; i < points.size(); ++i) {
    if (i % 1024 == 0) host.report("welding", i, points.size());
    if (to[i] != no_index) continue;
    to[i] = i;
    search.for_each_within(points[i], distance, [&](Index j) {
      if (to[j] == no_index) to[j] = i;
    });
  }
  return to;
}

}  // namespace

WeldFigures weld_open_edges(Soup& soup, double distance, const Context& context) {
  const base::Host& host = context.host;
  const Array<Index> open = open_vertices(soup, host);
  Array<Vector3> points(host.memory);
  points.reserve(open.size());
  for (const Index v : open)
    points.push_back(soup.positions[v]);
  const Array<Index> to = representatives(points, distance, host);

  WeldFigures figures;
  Array<Index> renumbered(soup.positions.size(), host.memory);
  for (Index v = 0; v < renumbered.size(); ++v)
    renumbered[v] = v;
  for (Index i = 0; i < open.size(); ++i) {
    if (to[i] == i) continue;
    renumbered[open[i]] = open[to[i]];
    const double moved = (points[i] - points[to[i]]).norm();
    figures.largest_move = std::max(figures.largest_move, moved);
    ++figures.vertices;
    context.record(Action::welded_vertex, points[i], moved);
  }
  if (figures.vertices == 0) return figures;
  Array<std::uint8_t> keep(soup.triangles.size(), 1, host.memory);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    Triangle& corners = soup.triangles[t];
    const bool whole = !mesh::has_repeated_corner(corners);
    for (Index& v : corners)
      v = renumbered[v];
    if (!whole || !mesh::has_repeated_corner(corners)) continue;
    keep[t] = 0;
    ++figures.triangles;
  }
  if (figures.triangles > 0) keep_triangles(soup, keep);
  return figures;
}

bool has_open_edges(const Soup& soup, const base::Host& host) {
  const mesh::EdgeTable edges(soup.positions.size(), soup.triangles, host);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.half_edges(e).size() % 2 == 1) return true;
  }
  return false;
}

}  // namespace orbicube::repair
