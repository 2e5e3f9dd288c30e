#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/heap.h"
#include "hexmesh/features/embedding.h"

namespace orbicube::hexmesh {
namespace {

constexpr int max_trials = 60, idle_trials = 15;             // the latter without fewer shared vertices than ever
constexpr double first_sharing = 0.3, sharing_growth = 1.3;  // price of a shared vertex, in cells
constexpr int growing_trials = 30;
constexpr double history = 0.4;                         // more for each trial in which a vertex was shared
constexpr double edge_price = 0.05, crowd_price = 0.1;  // of each edge; of each used vertex beside a path

class Router {
 public:
  Router(const HexMesh& mesh, const BoundaryQuads& quads, const FeatureShape& shape, double price, Embedding& embedding,
         const base::Host& host)
      : mesh_(mesh),
        quads_(quads),
        shape_(shape),
        price_(price),
        embedding_(embedding),
        host_(host),
        reserved_(mesh.positions.size(), no_index, host.memory),
        used_(mesh.positions.size(), 0, host.memory),
        history_(mesh.positions.size(), 0, host.memory),
        cost_(mesh.positions.size(), infinite, host.memory),
        from_(mesh.positions.size(), no_index, host.memory),
        reached_(host.memory),
        distances_(host.memory) {}

  std::optional<FeatureObstacle> run() {
    begin();
    Array<Index> order(shape_.arcs(), host_.memory);
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return shape_.length(a) < shape_.length(b); });
    std::size_t least = no_index;
    int idle = 0;
    for (int trial = 0; trial < max_trials && idle < idle_trials; ++trial) {
      sharing_ = first_sharing * std::pow(sharing_growth, std::min(trial, growing_trials));
      for (const Index a : order) {
        if (!find_path(a)) return FeatureObstacle{no_index, a, "other arcs shut the arc in"};
      }
      std::size_t conflicts = 0;
      for (const Index v : quads_.vertices()) {
        if (used_[v] < 2) continue;
        ++conflicts;
        history_[v] += history;
      }
      if (conflicts == 0) return {};
      idle = conflicts < least ? 0 : idle + 1;
      least = std::min(least, conflicts);
    }
    for (const Index a : order) {
      const auto& path = embedding_.paths[a];
      if (std::any_of(path.begin(), path.end(), [&](Index v) { return used_[v] > 1; }))
        return FeatureObstacle{no_index, a, "the arc and others need the same edges; there are too few cells along it"};
    }
    return {};
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr Index at_corner = no_index - 1;

  void begin() {
    for (const Index v : embedding_.corner_vertices)
      reserved_[v] = at_corner;
    for (Index a = 0; a < shape_.arcs(); ++a) {
      for (const Index v : embedding_.arc_ends[a]) {
        if (reserved_[v] != at_corner) reserved_[v] = a;
      }
    }
    embedding_.paths.clear();
    embedding_.paths.resize(shape_.arcs(), Array<Index>(host_.memory));
    distances_.resize(shape_.arcs(), Array<float>(host_.memory));
  }

  // From an arc to a vertex of the boundary, in cells.
  double distance(Index arc, Index v) {
    Array<float>& known = distances_[arc];
    if (known.empty()) known.assign(mesh_.positions.size(), -1);
    if (known[v] < 0) known[v] = static_cast<float>(shape_.nearest_on_arc(arc, mesh_.positions[v]).distance);
    return known[v];
  }

  double step(Index arc, Index from, Index to) {
    const double d = distance(arc, to);
    double cost = (mesh_.positions[to] - mesh_.positions[from]).norm() * (1 + price_ * d * d) + edge_price +
                  history_[to] + sharing_ * used_[to];
    quads_.for_each_outgoing(to, [&](Index h) {
      if (used_[quads_.end(h)] > 0) cost += crowd_price;
    });
    return cost;
  }

  bool find_path(Index arc) {
    Array<Index>& path = embedding_.paths[arc];
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
      --used_[path[i]];
    path.clear();
    const auto& corners = shape_.graph().arcs[arc].corners;
    const Index begin = embedding_.corner_vertices[corners[0]], end = embedding_.corner_vertices[corners[1]];
    const auto [first, last] = embedding_.arc_ends[arc];
    if (first == end) {
      path.assign({begin, end});
      return true;
    }
    if (!search(arc, first, last)) return false;
    path.push_back(end);
    for (Index v = last; v != no_index; v = from_[v]) {
      path.push_back(v);
      ++used_[v];
    }
    path.push_back(begin);
    std::reverse(path.begin(), path.end());
    return true;
  }

  // Shortest path (Dijkstra); from_ leads back from `last`.
  bool search(Index arc, Index first, Index last) {
    for (const Index v : reached_)
      cost_[v] = infinite;
    reached_.clear();
    using Open = std::pair<double, Index>;
    base::Heap<Open> queue(host_.memory);
    const auto reach = [&](Index v, Index from, double cost) {
      if (cost >= cost_[v]) return;
      if (cost_[v] == infinite) reached_.push_back(v);
      cost_[v] = cost;
      from_[v] = from;
      queue.push({cost, v});
    };
    reach(first, no_index, 0);
    while (!queue.empty()) {
      const auto [cost, v] = queue.pop();
      if (cost > cost_[v]) continue;
      host_.report("features", 0, 0);
      if (v == last) return true;
      quads_.for_each_outgoing(v, [&, at = v, so_far = cost](Index h) {
        const Index w = quads_.end(h);
        if (reserved_[w] == no_index || reserved_[w] == arc) reach(w, at, so_far + step(arc, at, w));
      });
    }
    return false;
  }

  const HexMesh& mesh_;
  const BoundaryQuads& quads_;
  const FeatureShape& shape_;
  const double price_;
  Embedding& embedding_;
  const base::Host& host_;
  Array<Index> reserved_;  // of each vertex: the arc whose first edge ends there
  Array<int> used_;        // of each vertex: paths through it
  Array<double> history_, cost_;
  Array<Index> from_, reached_;
  Array<Array<float>> distances_;  // of each arc, from vertices, where they are known
  double sharing_ = 0;
};

}  // namespace

std::optional<FeatureObstacle> route_arcs(const HexMesh& mesh, const BoundaryQuads& quads, const FeatureShape& shape,
                                          double price, Embedding& embedding, const base::Host& host) {
  return Router(mesh, quads, shape, price, embedding, host).run();
}

}  // namespace orbicube::hexmesh
