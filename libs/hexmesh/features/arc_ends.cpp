#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "hexmesh/features/embedding.h"
#include "hexmesh/features/pillowing.h"

namespace orbicube::hexmesh {
namespace {

constexpr double impossible = 1e3;  // cost of an edge that an arc cannot have
constexpr int max_raises = 8;       // of one corner, until it has an edge for each arc
constexpr int max_tries = 4;        // to raise it further where its edges lead to other corners

class Stubs {
 public:
  Stubs(HexMesh& mesh, BoundaryQuads& quads, const FeatureShape& shape, Embedding& embedding, const base::Host& host)
      : mesh_(mesh),
        quads_(quads),
        shape_(shape),
        embedding_(embedding),
        host_(host),
        indirect_(shape.arcs(), 0, host.memory),
        tries_(shape.corners(), 0, host.memory),
        taken_(host.memory) {}

  std::optional<FeatureObstacle> run() {
    for (Index c = 0; c < shape_.corners(); ++c)
      raise(c);
    bool again = true;
    while (again) {
      again = false;
      begin();
      for (Index c = 0; c < shape_.corners() && !again; ++c) {
        host_.report("features", c, shape_.corners());
        if (shape_.graph().around.size(c) == 0 || choose(c)) continue;
        if (!make_way(c))
          return FeatureObstacle{c, no_index, "the boundary has no free edges for the arcs of the corner"};
        again = true;
      }
    }
    return {};
  }

 private:
  static constexpr Index at_corner = no_index - 1;  // in taken_

  Index vertex(Index corner) const { return embedding_.corner_vertices[corner]; }
  Vector3 edge(Index v, Index w) const { return (mesh_.positions[w] - mesh_.positions[v]).normalized(); }

  Array<Index> ring(Index v) const {
    Array<Index> result(host_.memory);
    quads_.for_each_outgoing(v, [&](Index h) { result.push_back(quads_.end(h)); });
    return result;
  }

  void begin() {
    taken_.assign(mesh_.positions.size(), no_index);
    for (const Index v : embedding_.corner_vertices)
      taken_[v] = at_corner;
    embedding_.fixed.resize(shape_.arcs(), Array<Index>(host_.memory));
    for (Index a = 0; a < shape_.arcs(); ++a) {
      const Array<Index>& path = embedding_.fixed[a];
      for (std::size_t i = 1; i + 1 < path.size(); ++i)
        taken_[path[i]] = a;
    }
    embedding_.arc_ends.assign(shape_.arcs(), {no_index, no_index});
  }

  void pillow_behind(Index v, Index w) {
    pillow_one(mesh_, quads_.owner(quads_.find(v, w) / 4), host_);
    quads_ = BoundaryQuads(mesh_.hexahedra, mesh_.positions.size(), host_);
  }

  // Gives a corner's vertex an edge for each arc, in the quad that most arcs leave through.
  void raise(Index corner) {
    const auto ends = shape_.graph().around[corner];
    const Index v = vertex(corner);
    for (int i = 0; i < max_raises && quads_.valence(v) < ends.size(); ++i) {
      const Array<Index> around = ring(v);
      Vector3 normal = Vector3::Zero();
      for (std::size_t k = 0; k < around.size(); ++k) {
        const Vector3 next = mesh_.positions[around[(k + 1) % around.size()]] - mesh_.positions[v];
        normal += (mesh_.positions[around[k]] - mesh_.positions[v]).cross(next);
      }
      normal.stableNormalize();
      const Vector3 first = edge(v, around[0]);
      const Vector3 x = (first - normal * normal.dot(first)).stableNormalized(), y = normal.cross(x);
      const auto angle = [&](const Vector3& d) {
        const double a = std::atan2(d.dot(y), d.dot(x));
        return a < 0 ? a + 2 * std::numbers::pi : a;
      };
      constexpr double share_of_angle = 0.3;
      double best = -1;
      Index at = around[0];
      for (std::size_t k = 0; k < around.size(); ++k) {
        const double low = k == 0 ? 0 : angle(edge(v, around[k]));
        const double high = k + 1 < around.size() ? angle(edge(v, around[k + 1])) : 2 * std::numbers::pi;
        double score = share_of_angle * (high - low);
        for (const mesh::FeatureEnd& end : ends) {
          const double a = angle(shape_.direction(end));
          if (a > low && a < high) score += 1;
        }
        if (score <= best) continue;
        best = score;
        at = around[k];
      }
      pillow_behind(v, at);
    }
  }

  double cost(Index corner, const mesh::FeatureEnd& end, Index w, std::span<const Index> around) const {
    if (const Array<Index>& path = embedding_.fixed[end.arc]; !path.empty())
      return w == (end.end == 0 ? path[1] : path[path.size() - 2]) ? 0 : impossible;
    const Index other = shape_.other_corner(end);
    const bool direct = indirect_[end.arc] == 0 && other != corner && shape_.length(end.arc) < short_arc &&
                        std::find(around.begin(), around.end(), vertex(other)) != around.end();
    if (direct) return w == vertex(other) ? 0 : impossible;
    if (taken_[w] != no_index && taken_[w] != end.arc) return impossible;
    return 1 - shape_.direction(end).dot(edge(vertex(corner), w));
  }

  // Edges in the order of the arcs at minimum total cost.
  bool choose(Index corner) {
    const auto ends = shape_.graph().around[corner];
    const Array<Index> around = ring(vertex(corner));
    const std::size_t n = around.size(), k = ends.size();
    Array<double> costs(k * n, host_.memory);
    for (std::size_t i = 0; i < k; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        costs[i * n + j] = cost(corner, ends[i], around[j], around);
    }
    double least = impossible / 2;
    Array<std::size_t> chosen(k, 0, host_.memory), best(host_.memory);
    const std::function<void(std::size_t, std::size_t, double)> search = [&](std::size_t i, std::size_t from,
                                                                             double sum) {
      if (sum >= least) return;
      if (i == k) {
        least = sum;
        best = chosen;
        return;
      }
      const std::size_t limit = i == 0 ? n : chosen[0] + n;
      for (std::size_t j = from; j + (k - 1 - i) < limit + (i == 0 ? k - 1 : 0); ++j) {
        chosen[i] = j;
        search(i + 1, j + 1, sum + costs[i * n + j % n]);
      }
    };
    search(0, 0, 0);
    if (best.empty()) return false;
    for (std::size_t i = 0; i < k; ++i) {
      const Index w = around[best[i] % n];
      embedding_.arc_ends[ends[i].arc][ends[i].end] = w;
      if (taken_[w] != at_corner) taken_[w] = ends[i].arc;
    }
    return true;
  }

  // Lets short arcs go round, then gives the vertex another edge.
  bool make_way(Index corner) {
    bool more = false;
    for (const mesh::FeatureEnd& end : shape_.graph().around[corner]) {
      more = more || indirect_[end.arc] == 0;
      indirect_[end.arc] = 1;
    }
    if (more) return true;
    if (tries_[corner]++ >= max_tries) return false;
    constexpr double price_of_taken = 0.3;  // radians
    const Index v = vertex(corner);
    const Array<Index> around = ring(v);
    double best = -std::numeric_limits<double>::infinity();
    Index at = around[0];
    for (std::size_t k = 0; k < around.size(); ++k) {
      const Index a = around[k], b = around[(k + 1) % around.size()];
      const double angle = std::acos(std::clamp(edge(v, a).dot(edge(v, b)), -1.0, 1.0));
      const double score =
          angle - (taken_[a] != no_index ? price_of_taken : 0) - (taken_[b] != no_index ? price_of_taken : 0);
      if (score <= best) continue;
      best = score;
      at = a;
    }
    pillow_behind(v, at);
    indirect_.assign(indirect_.size(), 0);
    return true;
  }

  HexMesh& mesh_;
  BoundaryQuads& quads_;
  const FeatureShape& shape_;
  Embedding& embedding_;
  const base::Host& host_;
  Array<std::uint8_t> indirect_;  // of each arc: it need not be one edge where its corners are neighbors
  Array<int> tries_;              // of each corner
  Array<Index> taken_;            // of each vertex: the arc that goes through it
};

}  // namespace

std::optional<FeatureObstacle> choose_arc_ends(HexMesh& mesh, BoundaryQuads& quads, const FeatureShape& shape,
                                               Embedding& embedding, const base::Host& host) {
  return Stubs(mesh, quads, shape, embedding, host).run();
}

}  // namespace orbicube::hexmesh
