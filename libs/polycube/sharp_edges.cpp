#include "polycube/sharp_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/connectivity.h"

namespace orbicube::polycube {
namespace {

// visit(half-edge, whether the solid is convex there) for one half-edge of each sharp edge.
template <class Visit>
void for_each_sharp(const SurfaceMap& map, const mesh::Connectivity& connectivity, double degrees,
                    const base::Host& host, const Visit& visit) {
  const double most = std::cos(degrees * std::numbers::pi / 180);
  const auto normal = [&](Index f) -> Vector3 {
    const auto& [a, b, c] = map.triangles[f];
    return (map.positions[b] - map.positions[a]).cross(map.positions[c] - map.positions[a]).stableNormalized();
  };
  for (Index h = 0; h < 3 * map.triangles.size(); ++h) {
    if (h % 4096 == 0) host.report("features", 0, 0);
    const Index other = connectivity.opposite(h);
    if (other < h) continue;
    // Pieces of one triangle are flat, whatever rounding makes of thin ones.
    if (map.triangle_sources[h / 3] == map.triangle_sources[other / 3]) continue;
    const Vector3 left = normal(h / 3), right = normal(other / 3);
    if (!(left.dot(right) <= most)) continue;
    const Vector3 beyond = map.positions[connectivity.end(mesh::Connectivity::next(other))];
    visit(h, left.dot(beyond - map.positions[connectivity.start(h)]) < 0);
  }
}

// Of p from the line between two points.
double distance_to(const Vector3& p, const Vector3& from, const Vector3& to) {
  const Vector3 way = to - from;
  const double part = std::clamp((p - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (from + part * way - p).norm();
}

Index common_corner(const PatchGraph& graph, Index first, Index second) {
  for (const Index a : {graph.origin(2 * first), graph.target(2 * first)})
    for (const Index b : {graph.origin(2 * second), graph.target(2 * second)})
      if (a == b) return a;
  return no_index;
}

}  // namespace

SharpEdges find_sharp_edges(const SurfaceMap& map, const PatchGraph& graph, double degrees, const base::Host& host) {
  constexpr double part = 0.06, along = 0.8;
  const mesh::Connectivity connectivity(map.positions.size(), map.triangles, host);
  Vector3 low = graph.corners[0], high = low;
  for (const Vector3& c : graph.corners) {
    low = low.cwiseMin(c);
    high = high.cwiseMax(c);
  }
  const double farthest = part * (high - low).norm();
  SharpEdges result(host.memory);
  // Up to two edges of the polycube a vertex.
  Array<std::array<Index, 2>> wanted(map.positions.size(), {no_index, no_index}, host.memory);
  for_each_sharp(map, connectivity, degrees, host, [&](Index h, bool convex) {
    const Index a = connectivity.start(h), b = connectivity.end(h);
    result.edges.push_back({a, b});
    result.length += (map.positions[b] - map.positions[a]).norm();
    const Vector3 way = (map.polycube[b] - map.polycube[a]).stableNormalized();
    const Vector3 middle = 0.5 * (map.polycube[a] + map.polycube[b]);
    Index nearest = no_index;
    double least = farthest;
    for (Index e = 0; e < graph.edges(); ++e) {
      if ((graph.convex[e] != 0) != convex) continue;
      const Vector3 &from = graph.corners[graph.origin(2 * e)], &to = graph.corners[graph.target(2 * e)];
      if (std::abs(way.dot((to - from).normalized())) < along) continue;
      const double distance = distance_to(middle, from, to);
      if (distance >= least) continue;
      least = distance;
      nearest = e;
    }
    if (nearest == no_index) return;
    for (const Index v : {a, b}) {
      auto& [first, second] = wanted[v];
      if (first == no_index || first == nearest)
        first = nearest;
      else
        second = nearest;
    }
  });
  for (Index v = 0; v < wanted.size(); ++v) {
    const auto& [first, second] = wanted[v];
    if (first == no_index) continue;
    SharpVertex sharp{v, first, no_index};
    if (second != no_index) {
      sharp.corner = common_corner(graph, first, second);
      if (sharp.corner == no_index) continue;
    }
    result.vertices.push_back(sharp);
  }
  return result;
}

double length_on_edges(const SurfaceMap& map, double degrees, const base::Host& host) {
  const mesh::Connectivity connectivity(map.positions.size(), map.triangles, host);
  double sum = 0;
  for_each_sharp(map, connectivity, degrees, host, [&](Index h, bool) {
    if (map.charts[h / 3] == map.charts[connectivity.opposite(h) / 3]) return;
    sum += (map.positions[connectivity.end(h)] - map.positions[connectivity.start(h)]).norm();
  });
  return sum;
}

}  // namespace orbicube::polycube
