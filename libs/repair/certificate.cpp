#include "repair/certificate.h"

#include <algorithm>

#include "mesh/search/intersections.h"
#include "mesh/search/nearest.h"
#include "mesh/topology/edge_table.h"
#include "mesh/topology/topology.h"

namespace orbicube::repair {
namespace {

// The largest distance of the given triangles' vertices and centroids from a surface.
double largest_distance(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                        const mesh::SurfaceSearch& surface, const base::Host& host) {
  double largest = 0;
  Index near = no_index;
  const auto look = [&](const Vector3& p) {
    const mesh::SurfacePoint found = surface.nearest(p, near);
    near = found.triangle;
    largest = std::max(largest, found.distance);
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (t % 256 == 0) host.report("measuring the distance", t, triangles.size());
    const Triangle& c = triangles[t];
    for (const Index v : c)
      look(positions[v]);
    look((positions[c[0]] + positions[c[1]] + positions[c[2]]) / 3);
  }
  return largest;
}

}  // namespace

Certificate certify(std::span<const Vector3> positions, std::span<const Triangle> triangles, bool intersections,
                    const base::Host& host) {
  const mesh::Topology t = mesh::topology(positions, triangles, host);
  Certificate c;
  c.closed = t.closed() && t.non_manifold_edges == 0;
  c.manifold = t.manifold();
  c.oriented = t.orientable && t.inconsistent_edges == 0;
  c.parts = t.components;
  if (c.is_solid()) c.genus = static_cast<std::int64_t>(t.components) - t.euler_characteristic / 2;
  c.boundary_loops = t.boundary_loops;
  c.non_manifold_edges = t.non_manifold_edges;
  c.non_manifold_vertices = t.non_manifold_vertices;
  c.inconsistent_edges = t.inconsistent_edges;
  c.zero_area_faces = t.zero_area_faces;
  c.area = t.area;
  c.volume = c.is_solid() ? t.volume : 0;
  if (intersections) {
    const auto pairs = mesh::intersecting_triangles(positions, triangles, host, max_pairs);
    c.self_intersections = pairs.size();
    if (!pairs.empty()) c.first_intersection = pairs[0][0];
  }
  return c;
}

Move measure_move(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                  std::span<const std::uint8_t> counted, const Soup& result, const base::Host& host) {
  Array<std::uint8_t> same(triangles.size(), 0, host.memory);
  Array<Triangle> moved(host.memory), patches(host.memory), gone(host.memory);
  for (std::size_t t = 0; t < result.triangles.size(); ++t) {
    const Index source = result.triangle_source[t];
    bool kept = source != no_index && same[source] == 0;
    // The same corners, in either order: a triangle that is turned has not moved.
    if (kept) {
      for (const Index v : result.triangles[t]) {
        kept = kept && std::any_of(triangles[source].begin(), triangles[source].end(),
                                   [&](Index w) { return result.positions[v] == positions[w]; });
      }
      kept = kept && !mesh::has_repeated_corner(triangles[source]);
    }
    if (kept) {
      same[source] = 1;
    } else {
      (source != no_index ? moved : patches).push_back(result.triangles[t]);
    }
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (same[t] == 0 && counted[t] != 0) gone.push_back(triangles[t]);
  }
  Move move;
  if (!moved.empty() || !patches.empty()) {
    const mesh::SurfaceSearch input(positions, triangles, host);
    move.from_result = largest_distance(result.positions, moved, input, host);
    move.patches = largest_distance(result.positions, patches, input, host);
  }
  if (!gone.empty() && !result.triangles.empty())
    move.from_input =
        largest_distance(positions, gone, mesh::SurfaceSearch(result.positions, result.triangles, host), host);
  return move;
}

}  // namespace orbicube::repair
