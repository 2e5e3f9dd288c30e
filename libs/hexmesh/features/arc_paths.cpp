#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/heap.h"
#include "hexmesh/features/embedding.h"

namespace orbicube::hexmesh {
namespace {

constexpr int max_trials = 60, idle_trials = 15;             // the latter without fewer shared vertices than ever
constexpr double first_sharing = 0.3, sharing_growth = 1.3;  // price of a shared vertex, in cells
constexpr int growing_trials = 30;
constexpr double history = 0.4;                         // more for each trial in which a vertex was shared
constexpr double edge_price = 0.05, crowd_price = 0.1;  // of each edge; of each used vertex beside a path
constexpr double reserved_price = 3,
                 end_price = 1;  // of the first edge of another arc; of another first edge, in cells

FeatureObstacle at_arc(Index arc, std::string why) {
  return {no_index, arc, std::move(why)};
}

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

  Routing run() {
    begin();
    Array<Index> order(shape_.arcs(), host_.memory);
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return shape_.length(a) < shape_.length(b); });
    Routing routing(host_.memory);
    std::size_t least = no_index;
    int idle = 0;
    for (int trial = 0; trial < max_trials && idle < idle_trials; ++trial) {
      sharing_ = first_sharing * std::pow(sharing_growth, std::min(trial, growing_trials));
      for (const Index a : order) {
        if (find_path(a)) continue;
        if (fix_path(a))
          routing.choose_again = true;
        else
          routing.obstacles.push_back(at_arc(a, "other arcs shut the arc in"));
      }
      if (routing.choose_again || !routing.obstacles.empty()) return routing;
      std::size_t conflicts = 0;
      for (const Index v : quads_.vertices()) {
        if (used_[v] < 2) continue;
        ++conflicts;
        history_[v] += history;
      }
      if (conflicts == 0) return routing;
      idle = conflicts < least ? 0 : idle + 1;
      least = std::min(least, conflicts);
    }
    // Without the shortest of those that meet there is none.
    for (const Index a : order) {
      const auto& path = embedding_.paths[a];
      if (std::none_of(path.begin(), path.end(), [&](Index v) { return used_[v] > 1; })) continue;
      remove_path(a);
      routing.obstacles.push_back(
          at_arc(a, "the arc and others need the same edges; there are too few cells along it"));
    }
    return routing;
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
      keep_free(a);
    }
    embedding_.paths.clear();
    embedding_.paths.resize(shape_.arcs(), Array<Index>(host_.memory));
    distances_.resize(shape_.arcs(), Array<float>(host_.memory));
  }

  // Leaves the vertices of a fixed path to it.
  void keep_free(Index arc) {
    const Array<Index>& path = embedding_.fixed[arc];
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
      reserved_[path[i]] = arc;
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

  void remove_path(Index arc) {
    Array<Index>& path = embedding_.paths[arc];
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
      --used_[path[i]];
    path.clear();
  }

  bool find_path(Index arc) {
    remove_path(arc);
    Array<Index>& path = embedding_.paths[arc];
    const auto& corners = shape_.graph().arcs[arc].corners;
    const Index begin = embedding_.corner_vertices[corners[0]], end = embedding_.corner_vertices[corners[1]];
    const auto [first, last] = embedding_.arc_ends[arc];
    if (first == end) {
      path.assign({begin, end});
      return true;
    }
    if (const Array<Index>& fixed = embedding_.fixed[arc]; !fixed.empty()) {
      path = fixed;
    } else {
      const auto open = [&](Index v) { return reserved_[v] == no_index || reserved_[v] == arc; };
      if (!search(arc, first, last, [&](Index, Index to) { return open(to) ? 0 : infinite; })) return false;
      path.push_back(begin);
      take_found(last, path);
      path.push_back(end);
    }
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
      ++used_[path[i]];
    return true;
  }

  // Appends what search() found.
  void take_found(Index last, Array<Index>& path) const {
    const auto begin = static_cast<std::ptrdiff_t>(path.size());
    for (Index v = last; v != no_index; v = from_[v])
      path.push_back(v);
    std::reverse(path.begin() + begin, path.end());
  }

  // Fixes a path of an arc that is shut in, through the first edges of others.
  bool fix_path(Index arc) {
    const auto& corners = shape_.graph().arcs[arc].corners;
    const Index begin = embedding_.corner_vertices[corners[0]], end = embedding_.corner_vertices[corners[1]];
    if (begin == end) return false;
    const auto [first, last] = embedding_.arc_ends[arc];
    const auto price = [&, first = first, last = last](Index from, Index to) {
      if (to == end) return from == last ? 0 : end_price;
      if (reserved_[to] == at_corner || (reserved_[to] != no_index && !embedding_.fixed[reserved_[to]].empty()))
        return infinite;
      return (reserved_[to] == no_index || reserved_[to] == arc ? 0 : reserved_price) +
             (from == begin && to != first ? end_price : 0);
    };
    if (!search(arc, begin, end, price)) return false;
    Array<Index>& path = embedding_.fixed[arc];
    take_found(end, path);
    keep_free(arc);
    return true;
  }

  // Shortest path (Dijkstra) with price(from, to) of an edge besides; from_ leads back from `last`.
  template <class Price>
  bool search(Index arc, Index first, Index last, const Price& price) {
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
        const double extra = price(at, w);
        if (extra < infinite) reach(w, at, so_far + extra + step(arc, at, w));
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

Routing route_arcs(const HexMesh& mesh, const BoundaryQuads& quads, const FeatureShape& shape, double price,
                   Embedding& embedding, const base::Host& host) {
  return Router(mesh, quads, shape, price, embedding, host).run();
}

}  // namespace orbicube::hexmesh
