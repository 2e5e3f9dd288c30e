#include "polycube/features/sharp_edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "mesh/topology/connectivity.h"
#include "mesh/topology/disjoint_sets.h"

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

// A sharp edge and the edge of the polycube that it belongs to.
struct Wanted {
  Index edge;
  std::array<Index, 2> ends;
  double distance;
};

// Where several rows of sharp edges run beside each other for one edge of the polycube, as along a chamfer, only the
// nearest of them can have it; the others get no_index.
void keep_one_of_parallel(const SurfaceMap& map, const PatchGraph& graph, Array<Wanted>& all, const base::Host& host) {
  std::stable_sort(all.begin(), all.end(), [](const Wanted& a, const Wanted& b) { return a.edge < b.edge; });
  struct Row {
    double sum = 0, low = 0, high = 0;
    Index count = 0;
  };
  mesh::DisjointSets sets(map.positions.size(), host.memory);
  Array<Index> row_of(map.positions.size(), no_index, host.memory);
  Array<Row> rows(host.memory);
  Array<Index> order(host.memory);
  for (std::size_t begin = 0, end = 0; begin < all.size(); begin = end) {
    const Index edge = all[begin].edge;
    int axis = 0;
    const Vector3 way = graph.corners[graph.target(2 * edge)] - graph.corners[graph.origin(2 * edge)];
    way.cwiseAbs().maxCoeff(&axis);
    for (end = begin; end < all.size() && all[end].edge == edge; ++end)
      sets.unite(all[end].ends[0], all[end].ends[1]);
    rows.clear();
    for (std::size_t i = begin; i < end; ++i) {
      Index& row = row_of[sets.find(all[i].ends[0])];
      const auto [low, high] = std::minmax(map.polycube[all[i].ends[0]][axis], map.polycube[all[i].ends[1]][axis]);
      if (row == no_index) {
        row = static_cast<Index>(rows.size());
        rows.push_back({0, low, high, 0});
      }
      Row& r = rows[row];
      r.sum += all[i].distance;
      r.low = std::min(r.low, low);
      r.high = std::max(r.high, high);
      ++r.count;
    }
    order.resize(rows.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return rows[a].sum * rows[b].count < rows[b].sum * rows[a].count; });
    constexpr double most_overlap = 0.1;
    for (std::size_t i = 0; i < order.size(); ++i) {
      Row& r = rows[order[i]];
      for (std::size_t k = 0; k < i; ++k) {
        const Row& before = rows[order[k]];
        const double overlap = std::min(r.high, before.high) - std::max(r.low, before.low);
        if (before.count > 0 && overlap > most_overlap * (r.high - r.low)) r.count = 0;
      }
    }
    for (std::size_t i = begin; i < end; ++i)
      if (rows[row_of[sets.find(all[i].ends[0])]].count == 0) all[i].edge = no_index;
    // For the next edge of the polycube everything is apart again.
    for (std::size_t i = begin; i < end; ++i)
      for (const Index v : all[i].ends)
        row_of[v] = no_index;
    sets = mesh::DisjointSets(map.positions.size(), host.memory);
  }
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
  Array<Wanted> all(host.memory);
  for_each_sharp(map, connectivity, degrees, host, [&](Index h, bool convex) {
    const Index a = connectivity.start(h), b = connectivity.end(h);
    result.edges.push_back({a, b});
    result.length += (map.positions[b] - map.positions[a]).norm();
    const Vector3 way = (map.polycube[b] - map.polycube[a]).stableNormalized();
    const Vector3 middle = 0.5 * (map.polycube[a] + map.polycube[b]);
    Wanted nearest{no_index, {a, b}, farthest};
    for (Index e = 0; e < graph.edges(); ++e) {
      if ((graph.convex[e] != 0) != convex) continue;
      const Vector3 &from = graph.corners[graph.origin(2 * e)], &to = graph.corners[graph.target(2 * e)];
      if (std::abs(way.dot((to - from).normalized())) < along) continue;
      const double distance = distance_to(middle, from, to);
      if (distance >= nearest.distance) continue;
      nearest.distance = distance;
      nearest.edge = e;
    }
    if (nearest.edge != no_index) all.push_back(nearest);
  });
  keep_one_of_parallel(map, graph, all, host);
  // Up to two edges of the polycube a vertex.
  Array<std::array<Index, 2>> wanted(map.positions.size(), {no_index, no_index}, host.memory);
  for (const Wanted& w : all) {
    if (w.edge == no_index) continue;
    for (const Index v : w.ends) {
      auto& [first, second] = wanted[v];
      if (first == no_index || first == w.edge)
        first = w.edge;
      else
        second = w.edge;
    }
  }
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
    if (map.patches[h / 3] == map.patches[connectivity.opposite(h) / 3]) return;
    sum += (map.positions[connectivity.end(h)] - map.positions[connectivity.start(h)]).norm();
  });
  return sum;
}

}  // namespace orbicube::polycube
