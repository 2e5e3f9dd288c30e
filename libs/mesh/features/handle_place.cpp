// The shortest of the curves of a tree of shortest paths and a cotree of faces (Erickson and Whittlesey 2005). It is
// the shortest of all that pass through the root and separate nothing; the next root lies on it, while it gets shorter.
#include "mesh/features/handle_place.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "base/grouping.h"
#include "base/heap.h"
#include "mesh/topology/disjoint_sets.h"
#include "mesh/topology/edge_table.h"

namespace orbicube::mesh {
namespace {

constexpr int max_roots = 6;
constexpr const char* handle_place_phase = "handles";

struct Link {
  Index to, edge;
};

class Curves {
 public:
  Curves(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host)
      : triangles_(triangles),
        host_(host),
        edges_(positions.size(), triangles, host),
        length_(edges_.size(), 0, host.memory),
        links_(host.memory),
        distance_(positions.size(), 0, host.memory),
        before_(positions.size(), no_index, host.memory) {
    for (Index e = 0; e < edges_.size(); ++e) {
      const auto [a, b] = ends(e);
      length_[e] = (positions[a] - positions[b]).norm();
    }
    links_.assign(positions.size(), [&](const auto& visit) {
      for (Index e = 0; e < edges_.size(); ++e) {
        const auto [a, b] = ends(e);
        visit(a, Link{b, e});
        visit(b, Link{a, e});
      }
    });
  }

  // The vertices of the shortest curve through the root, in order, and its length; empty without handles.
  std::pair<std::vector<Index>, double> through(Index root) {
    grow_tree(root);
    const auto closing = [&](Index e) { return distance_[ends(e).first] + distance_[ends(e).second] + length_[e]; };
    Array<Index> order(host_.memory);
    for (Index e = 0; e < edges_.size(); ++e)
      if (before_[ends(e).first] != e && before_[ends(e).second] != e) order.push_back(e);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return closing(a) > closing(b); });
    // Longest first, edges join faces without a cycle; the others close the basis of curves, the last one the shortest.
    DisjointSets faces(triangles_.size(), host_.memory);
    Index best = no_index;
    for (const Index e : order) {
      const auto sides = edges_.half_edges(e);
      const auto a = faces.find(triangle_of(sides[0])), b = faces.find(triangle_of(sides[1]));
      if (a == b)
        best = e;
      else
        faces.unite(a, b);
    }
    if (best == no_index) return {};
    return curve_of(best);
  }

 private:
  std::pair<Index, Index> ends(Index e) const {
    const Index h = edges_.half_edges(e)[0];
    return {start_of(triangles_, h), end_of(triangles_, h)};
  }

  Index other_end(Index e, Index v) const { return ends(e).first == v ? ends(e).second : ends(e).first; }

  void grow_tree(Index root) {
    std::fill(distance_.begin(), distance_.end(), std::numeric_limits<double>::infinity());
    std::fill(before_.begin(), before_.end(), no_index);
    using Entry = std::pair<double, Index>;
    base::Heap<Entry> queue(host_.memory);
    distance_[root] = 0;
    queue.push({0, root});
    for (std::size_t popped = 0; !queue.empty(); ++popped) {
      if (popped % 4096 == 0) host_.report(handle_place_phase, std::min(popped, distance_.size()), distance_.size());
      const auto [d, v] = queue.pop();
      if (d > distance_[v]) continue;
      for (const auto& [to, e] : links_[v]) {
        if (!(d + length_[e] < distance_[to])) continue;
        distance_[to] = d + length_[e];
        before_[to] = e;
        queue.push({distance_[to], to});
      }
    }
  }

  // Without the path that both of its ways to the root share.
  std::pair<std::vector<Index>, double> curve_of(Index edge) const {
    std::vector<Index> ways[2];
    for (const bool second : {false, true}) {
      std::vector<Index>& way = ways[second ? 1 : 0];
      Index v = second ? ends(edge).second : ends(edge).first;
      way.push_back(v);
      while (before_[v] != no_index) {
        v = other_end(before_[v], v);
        way.push_back(v);
      }
    }
    while (ways[0].size() > 1 && ways[1].size() > 1 && ways[0][ways[0].size() - 2] == ways[1][ways[1].size() - 2]) {
      ways[0].pop_back();
      ways[1].pop_back();
    }
    const double shared = 2 * distance_[ways[0].back()];
    const double length = distance_[ways[0].front()] + distance_[ways[1].front()] + length_[edge] - shared;
    ways[0].insert(ways[0].end(), ways[1].rbegin() + 1, ways[1].rend());
    return {std::move(ways[0]), length};
  }

  std::span<const Triangle> triangles_;
  const base::Host& host_;
  EdgeTable edges_;
  Array<double> length_;
  base::Groups<Link> links_;  // of each vertex
  Array<double> distance_;
  Array<Index> before_;  // edge of each vertex on its way to the root
};

}  // namespace

std::optional<Index> handle_place(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                  const base::Host& host) {
  if (triangles.empty()) return std::nullopt;
  Curves curves(positions, triangles, host);
  std::optional<Index> result;
  double shortest = std::numeric_limits<double>::infinity();
  Index root = triangles[0][0];
  for (int i = 0; i < max_roots; ++i) {
    const auto [curve, length] = curves.through(root);
    if (curve.empty() || !(length < shortest)) break;
    shortest = length;
    result = curve.front();
    // Far from the place where the curve left the root.
    root = curve[curve.size() / 2];
  }
  return result;
}

}  // namespace orbicube::mesh
