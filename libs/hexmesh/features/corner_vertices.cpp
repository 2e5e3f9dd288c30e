#include <algorithm>
#include <limits>
#include <numeric>

#include "hexmesh/features/embedding.h"

namespace orbicube::hexmesh {
namespace {

// Costs, in cells.
constexpr double missing_edge = 0.25;  // each: fewer edges than arcs
constexpr double two_arcs_three_edges = 0.2;
constexpr double wrong_direction = 0.3;  // of an arc at a right angle to the nearest edge
constexpr int rings_apart = 2;

class Placement {
 public:
  Placement(const HexMesh& mesh, const BoundaryQuads& quads, const FeatureShape& shape, const base::Host& host)
      : mesh_(mesh),
        quads_(quads),
        shape_(shape),
        host_(host),
        near_(mesh.positions.size(), Array<Index>(host.memory), host.memory) {}

  std::optional<FeatureObstacle> run(Array<Index>& vertices) {
    vertices.assign(shape_.corners(), no_index);
    Array<Index> order(shape_.corners(), host_.memory);
    std::iota(order.begin(), order.end(), Index{0});
    const auto& around = shape_.graph().around;
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return around.size(a) > around.size(b); });
    for (const Index c : order) {
      const Index v = best_vertex(c, vertices);
      if (v == no_index) return FeatureObstacle{c, no_index, "no vertex of the boundary is left for the corner"};
      vertices[c] = v;
      mark_rings(c, v);
    }
    return {};
  }

 private:
  Index best_vertex(Index corner, std::span<const Index> vertices) {
    double least = std::numeric_limits<double>::infinity();
    Index best = no_index;
    for (const Index v : quads_.vertices()) {
      if (v % 4096 == 0) host_.report("features", 0, 0);
      const double distance = (mesh_.positions[v] - shape_.corner(corner)).norm();
      if (distance >= least || banned(corner, v, vertices)) continue;
      const double cost = distance + cost_of_edges(corner, v, least - distance);
      if (cost >= least) continue;
      least = cost;
      best = v;
    }
    return best;
  }

  bool banned(Index corner, Index v, std::span<const Index> vertices) const {
    return std::any_of(near_[v].begin(), near_[v].end(),
                       [&](Index other) { return vertices[other] == v || !shape_.joined(corner, other, short_arc); });
  }

  double cost_of_edges(Index corner, Index v, double most) const {
    const auto ends = shape_.graph().around[corner];
    const std::size_t edges = quads_.valence(v);
    double cost = edges < ends.size() ? missing_edge * static_cast<double>(ends.size() - edges) : 0;
    if (ends.size() == 2 && edges == 3) cost += two_arcs_three_edges;
    for (const mesh::FeatureEnd& end : ends) {
      if (cost >= most) return cost;
      const Vector3 direction = shape_.direction(end);
      double off = 1;
      quads_.for_each_outgoing(v, [&](Index h) {
        const Vector3 edge = (mesh_.positions[quads_.end(h)] - mesh_.positions[v]).normalized();
        off = std::min(off, 1 - direction.dot(edge));
      });
      cost += wrong_direction * off;
    }
    return cost;
  }

  void mark_rings(Index corner, Index v) {
    Array<Index> reached({v}, host_.memory);
    std::size_t begin = 0;
    for (int ring = 0; ring < rings_apart; ++ring) {
      const std::size_t end = reached.size();
      for (; begin < end; ++begin) {
        quads_.for_each_outgoing(reached[begin], [&](Index h) {
          if (std::find(reached.begin(), reached.end(), quads_.end(h)) == reached.end())
            reached.push_back(quads_.end(h));
        });
      }
    }
    for (const Index w : reached)
      near_[w].push_back(corner);
  }

  const HexMesh& mesh_;
  const BoundaryQuads& quads_;
  const FeatureShape& shape_;
  const base::Host& host_;
  Array<Array<Index>> near_;  // of each vertex, the corners within the rings
};

}  // namespace

std::optional<FeatureObstacle> place_corners(const HexMesh& mesh, const BoundaryQuads& quads, const FeatureShape& shape,
                                             Embedding& embedding, const base::Host& host) {
  return Placement(mesh, quads, shape, host).run(embedding.corner_vertices);
}

}  // namespace orbicube::hexmesh
