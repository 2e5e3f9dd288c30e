#include "polycube/layout/tracing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "base/error.h"
#include "base/heap.h"
#include "mesh/topology/disjoint_sets.h"
#include "polycube/layout/path_search.h"

namespace orbicube::polycube {
namespace {

constexpr const char* phase = "tracing";
// A path may go this far from its guide, in parts of the surface's diagonal, for four times the cost of its length.
constexpr double guide_width = 0.08, guide_strength = 3;
// What a turned normal counts for when a node looks for its vertex, in parts of the diagonal, and a node beside it.
constexpr double normal_weight = 0.12, crowding = 0.03;
constexpr std::size_t vertices_a_node = 12;
// How many times its faces a surface may have in the end; a tenth more than it has serves as a rule. One with few faces
// may have more of them, but not any number: paths without room wind around one another, and each makes the surface
// grow by a part of what it is, so that searches in it would soon take minutes.
constexpr std::size_t max_refinement = 24, small_surface = 40'000;

class Tracing {
 public:
  Tracing(const Layout& layout, const LayoutGuide& guide, EditableSurface& surface, const base::Host& host)
      : layout_(layout),
        guide_(guide),
        surface_(surface),
        host_(host),
        search_(surface, host),
        drawing_(host.memory),
        level_(surface.vertices(), 0, host.memory),
        drawn_(layout.arcs(), 0, host.memory),
        cost_(layout.arcs(), 0.0, host.memory),
        waiting_(host.memory),
        starts_(host.memory),
        ends_(host.memory) {
    Vector3 low = surface.position[surface.triangle[0][0]], high = low;
    for (const Triangle& t : surface.triangle) {
      for (const Index v : t) {
        low = low.cwiseMin(surface.position[v]);
        high = high.cwiseMax(surface.position[v]);
      }
    }
    diagonal_ = (high - low).norm();
    max_faces_ = max_refinement * surface.faces();
  }

  Drawing run() {
    refine_for_nodes();
    place_nodes();
    drawing_.path.resize(layout_.arcs());
    measure_arcs();
    draw_tree();
    draw_rest();
    label();
    return std::move(drawing_);
  }

 private:
  // Arcs that wait to be drawn, the cheapest first. What is drawn only makes the others costlier, so an arc that was
  // priced before is priced again when its turn comes, and goes back if it is no longer the cheapest.
  struct Waiting {
    double cost;
    Index arc;

    bool operator>(const Waiting& other) const { return cost != other.cost ? cost > other.cost : arc > other.arc; }
  };

  Index split_edge(Index h) {
    const Index a = surface_.start(h), b = surface_.end(h);
    if (surface_.faces() > max_faces_)
      throw base::Error("no-valid-result", "drawing the polycube's edges would refine the surface beyond measure");
    const Index m = surface_.split_edge(h, 0.5);
    level_.push_back(static_cast<std::uint8_t>(std::min(250, std::max(level_[a], level_[b]) + 1)));
    return m;
  }

  // Splits the longest edges while there are too few vertices for the nodes.
  void refine_for_nodes() {
    const std::size_t wanted = vertices_a_node * layout_.nodes.size();
    const std::size_t faces = 2 * wanted;  // of a closed surface with that number of vertices
    if (faces > std::max(max_faces_, small_surface / 4))
      throw base::Error("no-valid-result", "the surface has too few triangles for a polycube with " +
                                               std::to_string(layout_.nodes.size()) + " corners and ends of cuts");
    max_faces_ = std::max(max_faces_, std::min(2 * max_refinement * faces, small_surface));
    std::size_t used = 0;
    for (Index v = 0; v < surface_.vertices(); ++v)
      used += surface_.outgoing(v) != no_index;
    if (used >= wanted) return;
    base::Heap<std::pair<double, Index>, std::less<>> queue(host_.memory);
    const auto push = [&](Index h) { queue.push({surface_.length(h), h}); };
    for (Index h = 0; h < 3 * surface_.faces(); ++h)
      if (h < surface_.opposite(h)) push(h);
    while (used < wanted) {
      const auto [length, h] = queue.pop();
      if (surface_.length(h) != length) {
        push(h);
        continue;
      }
      const Index m = split_edge(h);
      level_.back() = 0;
      ++used;
      surface_.for_each_outgoing(m, push);
    }
  }

  void place_nodes() {
    const auto& positions = surface_.position;
    Array<Vector3> normals(positions.size(), Vector3::Zero(), host_.memory);
    for (const Triangle& t : surface_.triangle) {
      const Vector3 normal = (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
      for (const Index v : t)
        normals[v] += normal;
    }
    for (Vector3& normal : normals)
      normal.normalize();
    Array<std::uint8_t> crowded(positions.size(), 0, host_.memory);
    Array<Index> order(layout_.nodes.size(), host_.memory);
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_partition(order.begin(), order.end(), [&](Index n) { return layout_.nodes[n].corner; });
    std::stable_partition(order.begin(), order.end(), [&](Index n) { return guide_.node_vertex[n] != no_index; });
    drawing_.node_vertex.assign(order.size(), no_index);
    for (const Index n : order) {
      host_.report(phase, 0, 0);
      const Vector3& wanted = guide_.node_position[n];
      double least = PathSearch::infinite;
      Index chosen = guide_.node_vertex[n];
      if (chosen != no_index && surface_.occupied[chosen])
        throw base::Error("no-valid-result", "two corners of the polycube are to be at one vertex");
      for (Index v = 0; v < positions.size() && guide_.node_vertex[n] == no_index; ++v) {
        if (surface_.occupied[v] || surface_.outgoing(v) == no_index) continue;
        const double cost = (positions[v] - wanted).norm() / diagonal_ +
                            normal_weight * (1 - normals[v].dot(guide_.node_normal[n])) + (crowded[v] ? crowding : 0);
        if (cost < least) {
          least = cost;
          chosen = v;
        }
      }
      if (chosen == no_index) throw base::Error("internal", "too few vertices for the nodes of a layout");
      drawing_.node_vertex[n] = chosen;
      surface_.occupied[chosen] = 1;
      surface_.for_each_outgoing(chosen, [&](Index h) { crowded[surface_.end(h)] = 1; });
    }
    unblock(drawing_.node_vertex);
  }

  // Splits what keeps paths from passing between drawn vertices.
  void unblock(std::span<const Index> vertices) {
    for (const Index v : vertices) {
      for (bool changed = true; changed;) {
        changed = false;
        Index edge = no_index, face = no_index;
        surface_.for_each_outgoing(v, [&](Index h) {
          const Index on = surface_.arc[h];
          if (edge == no_index && on == no_index && surface_.occupied[surface_.end(h)]) edge = h;
          const Index f = h / 3;
          if (surface_.arc[3 * f] != no_index && surface_.arc[3 * f + 1] != no_index &&
              surface_.arc[3 * f + 2] != no_index)
            face = f;
        });
        if (edge != no_index) {
          split_edge(edge);
          changed = true;
        } else if (face != no_index) {
          surface_.split_face(face);
          level_.push_back(1);
          changed = true;
        }
      }
    }
  }

  // Half-edges that the path of a dart may leave its node by: those between the drawn darts beside it in the rotation.
  void sector(Index dart, Array<Index>& half_edges) const {
    const Index node = layout_.origin(dart), vertex = drawing_.node_vertex[node];
    const auto around = layout_.darts_of(node);
    const auto place = static_cast<std::size_t>(std::find(around.begin(), around.end(), dart) - around.begin());
    half_edges.clear();
    for (std::size_t back = 1; back < around.size(); ++back) {
      const Index before = around[(place + around.size() - back) % around.size()];
      if (!drawn_[before / 2]) continue;
      const auto& path = drawing_.path[before / 2];
      const Index second = before % 2 == 0 ? path[1] : path[path.size() - 2];
      for (Index h = surface_.turned(surface_.between(vertex, second)); surface_.arc[h] == no_index;
           h = surface_.turned(h))
        half_edges.push_back(h);
      return;
    }
    surface_.for_each_outgoing(vertex, [&](Index h) {
      if (surface_.arc[h] == no_index) half_edges.push_back(h);
    });
  }

  // Length, more expensive far from the line that guides the arc and where the surface has been split for other arcs.
  auto guided_cost(Index arc) const {
    return [this, &line = guide_.arc[arc]](Index h) {
      const Index v = surface_.start(h), w = surface_.end(h);
      const Vector3 middle = 0.5 * (surface_.position[v] + surface_.position[w]);
      double squared = PathSearch::infinite;
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Vector3 from = middle - line[i], along = line[i + 1] - line[i];
        const double length = along.squaredNorm();
        const double t = length > 0 ? std::clamp(from.dot(along) / length, 0.0, 1.0) : 0;
        squared = std::min(squared, (from - t * along).squaredNorm());
      }
      const double off = std::sqrt(squared) / (guide_width * diagonal_);
      const double split = std::max(level_[v], level_[w]);
      return (surface_.length(h) + 1e-9 * diagonal_) * (1 + guide_strength * off * off) * (1 + 0.5 * split * split);
    };
  }

  void measure_arcs() {
    for (Index arc = 0; arc < layout_.arcs(); ++arc) {
      host_.report(phase, 0, 0);
      cost_[arc] = route(arc, false);
    }
  }

  // The path of an arc beside what is drawn; sets drawing_.path, returns its cost.
  double route(Index arc, bool generator) {
    const Index from = drawing_.node_vertex[layout_.origin(2 * arc)];
    const Index to = drawing_.node_vertex[layout_.target(2 * arc)];
    Array<Index>& path = drawing_.path[arc];
    sector(2 * arc, starts_);
    sector(2 * arc + 1, ends_);
    const double cost = search_.find(from, starts_, to, ends_, {}, guided_cost(arc), path);
    if (cost == PathSearch::infinite) throw base::Error("internal", "no way for an edge of the polycube");
    if (!generator) return cost;
    mark(arc, path, true);
    const bool connected = sides_connected(path);
    mark(arc, path, false);
    return connected ? cost : find_generator(arc, path);
  }

  // Takes arcs off the queue until the first has the cost that it is there for; draws that.
  template <class Wanted>
  Index draw_cheapest(bool generators, const Wanted& wanted) {
    while (!waiting_.empty()) {
      host_.report(phase, drawn_count_, layout_.arcs());
      const Index arc = waiting_.pop().arc;
      if (!wanted(arc)) continue;
      const double cost = route(arc, generators);
      if (!waiting_.empty() && cost > waiting_.top().cost * (1 + 1e-12)) {
        waiting_.push({cost, arc});
        continue;
      }
      mark(arc, drawing_.path[arc], true);
      drawn_[arc] = 1;
      ++drawn_count_;
      unblock(drawing_.path[arc]);
      return arc;
    }
    return no_index;
  }

  // Prim's spanning tree: the drawn graph stays connected, and each node is reached by the cheapest way.
  void draw_tree() {
    Array<std::uint8_t> reached(layout_.nodes.size(), 0, host_.memory);
    std::size_t count = 0;
    const auto reach = [&](Index node) {
      reached[node] = 1;
      ++count;
      for (const Index dart : layout_.darts_of(node))
        if (!reached[layout_.target(dart)]) waiting_.push({cost_[dart / 2], dart / 2});
    };
    // From the cheapest arc's node.
    const auto first = static_cast<Index>(std::min_element(cost_.begin(), cost_.end()) - cost_.begin());
    reach(layout_.origin(2 * first));
    while (count < layout_.nodes.size()) {
      const Index arc = draw_cheapest(
          false, [&](Index a) { return !reached[layout_.origin(2 * a)] || !reached[layout_.target(2 * a)]; });
      if (arc == no_index) throw base::Error("internal", "a layout that is not connected");
      const Index end = layout_.origin(2 * arc);
      reach(reached[end] ? layout_.target(2 * arc) : end);
    }
    waiting_.clear();
  }

  // The cotree takes the costliest arcs of the rest; what it leaves are the generators, which come first.
  void draw_rest() {
    Array<Index> rest(host_.memory), generators(host_.memory), cotree(host_.memory);
    for (Index arc = 0; arc < layout_.arcs(); ++arc)
      if (!drawn_[arc]) rest.push_back(arc);
    std::sort(rest.begin(), rest.end(),
              [&](Index a, Index b) { return cost_[a] != cost_[b] ? cost_[a] > cost_[b] : a < b; });
    mesh::DisjointSets sets(layout_.rectangles.size(), host_.memory);
    for (const Index arc : rest) {
      const Index left = sets.find(layout_.dart_left[2 * arc]), right = sets.find(layout_.dart_left[2 * arc + 1]);
      (left == right ? generators : cotree).push_back(arc);
      sets.unite(left, right);
    }
    const auto any = [](Index) { return true; };
    for (const bool generator : {true, false}) {
      for (const Index arc : generator ? generators : cotree)
        waiting_.push({cost_[arc], arc});
      while (draw_cheapest(generator, any) != no_index) {
      }
    }
  }

  void mark(Index arc, std::span<const Index> path, bool on) {
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      surface_.draw(surface_.between(path[i], path[i + 1]), on ? arc : no_index);
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
      surface_.occupied[path[i]] = on;
  }

  // Whether one can go from the left of a drawn path to its right without crossing what is drawn.
  bool sides_connected(std::span<const Index> path) {
    const Index h = surface_.between(path[0], path[1]);
    const Index goal = surface_.opposite(h) / 3;
    Array<std::uint8_t> seen(surface_.faces(), 0, host_.memory);
    Array<Index> waiting(1, h / 3, host_.memory);
    seen[h / 3] = 1;
    while (!waiting.empty()) {
      const Index f = waiting.back();
      waiting.pop_back();
      if (f == goal) return true;
      for (Index k = 0; k < 3; ++k) {
        const Index across = surface_.opposite(3 * f + k) / 3;
        if (surface_.arc[3 * f + k] != no_index || seen[across]) continue;
        seen[across] = 1;
        waiting.push_back(across);
      }
    }
    return false;
  }

  // The closed curves, as half-edges that they cross, of a tree of free vertices and a cotree of faces of what is not
  // drawn: visit(odd) for each. A path leaves its sides connected exactly when it crosses one of them an odd number of
  // times.
  template <class Visit>
  void for_each_loop(const Visit& visit) {
    const std::size_t half_edges = 3 * surface_.faces();
    Array<std::uint8_t> in_tree(half_edges, 0, host_.memory), in_cotree(half_edges, 0, host_.memory);
    Array<std::uint8_t> seen(surface_.vertices(), 0, host_.memory);
    Array<Index> queue(host_.memory);
    for (Index v = 0; v < surface_.vertices() && queue.empty(); ++v)
      if (!surface_.occupied[v] && surface_.outgoing(v) != no_index) queue.push_back(v);
    if (queue.empty()) return;
    seen[queue[0]] = 1;
    const Index first = surface_.outgoing(queue[0]) / 3;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      surface_.for_each_outgoing(queue[i], [&](Index h) {
        const Index w = surface_.end(h);
        if (surface_.occupied[w] || seen[w]) return;
        seen[w] = 1;
        in_tree[h] = in_tree[surface_.opposite(h)] = 1;
        queue.push_back(w);
      });
    }
    Array<Index> towards(surface_.faces(), no_index, host_.memory);  // half-edge of a face to the one before it
    queue.assign(1, first);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (Index k = 0; k < 3; ++k) {
        const Index h = 3 * queue[i] + k, t = surface_.opposite(h);
        if (surface_.arc[h] != no_index || in_tree[h] || t / 3 == first || towards[t / 3] != no_index) continue;
        towards[t / 3] = t;
        in_cotree[h] = in_cotree[t] = 1;
        queue.push_back(t / 3);
      }
    }
    Array<std::uint8_t> odd(host_.memory);
    for (const Index f : queue) {
      for (Index k = 0; k < 3; ++k) {
        const Index h = 3 * f + k, t = surface_.opposite(h);
        if (h > t || surface_.arc[h] != no_index || in_tree[h] || in_cotree[h]) continue;
        odd.assign(half_edges, 0);
        const auto cross = [&](Index x) {
          odd[x] ^= 1;
          odd[surface_.opposite(x)] ^= 1;
        };
        cross(h);
        for (Index side : {h / 3, t / 3}) {
          while (side != first) {
            cross(towards[side]);
            side = surface_.opposite(towards[side]) / 3;
          }
        }
        visit(odd);
      }
    }
  }

  // The cheapest path found that does not separate the surface; returns its cost.
  double find_generator(Index arc, Array<Index>& path) {
    const Index from = drawing_.node_vertex[layout_.origin(2 * arc)];
    const Index to = drawing_.node_vertex[layout_.target(2 * arc)];
    sector(2 * arc, starts_);
    sector(2 * arc + 1, ends_);
    const auto cost = guided_cost(arc);
    double least = PathSearch::infinite;
    Array<Index> found(host_.memory), best(host_.memory);
    Array<std::pair<double, Array<Index>>> crossing(host_.memory);  // paths that pass a vertex twice
    for_each_loop([&](const Array<std::uint8_t>& odd) {
      const double length = search_.find(from, starts_, to, ends_, odd, cost, found);
      if (!(length < least)) return;
      if (first_repeated(found) < found.size()) {
        crossing.emplace_back(length, Array<Index>(found.begin(), found.end(), host_.memory));
        return;
      }
      least = length;
      best = found;
    });
    if (!best.empty()) {
      path = best;
      return least;
    }
    std::stable_sort(crossing.begin(), crossing.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [length, twice] : crossing)
      if (open_loop(arc, twice, path)) return length;
    throw base::Error("no-valid-result", "no path was found for an edge that goes around a handle");
  }

  std::size_t first_repeated(std::span<const Index> path) {
    Array<std::uint8_t> seen(surface_.vertices(), 0, host_.memory);
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (seen[path[i]]) return i;
      seen[path[i]] = 1;
    }
    return path.size();
  }

  // A path that passes a vertex twice, cut before the second time; from there on by any way that is left.
  bool open_loop(Index arc, std::span<const Index> twice, Array<Index>& path) {
    const std::size_t cut = first_repeated(twice);
    if (cut < 3) return false;
    const Index to = drawing_.node_vertex[layout_.target(2 * arc)];
    Array<Index> first(twice.begin(), twice.begin() + static_cast<std::ptrdiff_t>(cut), host_.memory);
    for (std::size_t i = 0; i + 1 < first.size(); ++i)
      if (surface_.between(first[i], first[i + 1]) == no_index) return false;  // an edge split meanwhile
    const auto show = [&](bool on) {
      mark(arc, first, on);
      surface_.occupied[first.back()] = on;
    };
    show(true);
    const std::size_t before = surface_.vertices();
    unblock(first);
    Array<Index> tip_starts(host_.memory), rest(host_.memory);
    surface_.for_each_outgoing(first.back(), [&](Index h) {
      if (surface_.arc[h] == no_index) tip_starts.push_back(h);
    });
    sector(2 * arc + 1, ends_);
    const double length = search_.find(first.back(), tip_starts, to, ends_, {}, guided_cost(arc), rest);
    show(false);
    if (surface_.vertices() != before) {
      // Half-edges have moved.
      sector(2 * arc, starts_);
      sector(2 * arc + 1, ends_);
    }
    if (length == PathSearch::infinite) return false;
    first.insert(first.end(), rest.begin() + 1, rest.end());
    mark(arc, first, true);
    const bool connected = sides_connected(first);
    mark(arc, first, false);
    if (connected) path = first;
    return connected;
  }

  // Floods the rectangles from the arcs, and checks that each is a disk with the corners that it should have.
  void label() {
    const auto rectangles = layout_.rectangles.size();
    drawing_.rectangle.assign(surface_.faces(), no_index);
    Array<Index> waiting(host_.memory);
    for (Index dart = 0; dart < 2 * layout_.arcs(); ++dart) {
      const auto& path = drawing_.path[dart / 2];
      const std::size_t n = path.size();
      const Index h = dart % 2 == 0 ? surface_.between(path[0], path[1]) : surface_.between(path[n - 1], path[n - 2]);
      const Index rectangle = layout_.dart_left[dart];
      Index& here = drawing_.rectangle[h / 3];
      if (here != no_index && here != rectangle) throw base::Error("internal", "two rectangles in one region");
      if (here == rectangle) continue;
      here = rectangle;
      waiting.push_back(h / 3);
      while (!waiting.empty()) {
        const Index f = waiting.back();
        waiting.pop_back();
        for (Index k = 0; k < 3; ++k) {
          const Index across = surface_.opposite(3 * f + k) / 3;
          if (surface_.arc[3 * f + k] != no_index || drawing_.rectangle[across] != no_index) continue;
          drawing_.rectangle[across] = rectangle;
          waiting.push_back(across);
        }
      }
    }
    // Euler numbers: interior vertices - interior edges + faces = 1 for an open disk.
    Array<std::int64_t> euler(rectangles, 0, host_.memory);
    for (Index f = 0; f < surface_.faces(); ++f) {
      if (drawing_.rectangle[f] == no_index) throw base::Error("internal", "a part of the surface without rectangle");
      ++euler[drawing_.rectangle[f]];
      for (Index k = 0; k < 3; ++k)
        if (surface_.arc[3 * f + k] == no_index && 3 * f + k < surface_.opposite(3 * f + k))
          --euler[drawing_.rectangle[f]];
    }
    for (Index v = 0; v < surface_.vertices(); ++v)
      if (!surface_.occupied[v] && surface_.outgoing(v) != no_index)
        ++euler[drawing_.rectangle[surface_.outgoing(v) / 3]];
    if (std::any_of(euler.begin(), euler.end(), [](std::int64_t e) { return e != 1; }))
      throw base::Error("internal", "a rectangle that is no disk");
  }

  const Layout& layout_;
  const LayoutGuide& guide_;
  EditableSurface& surface_;
  const base::Host& host_;
  PathSearch search_;
  Drawing drawing_;
  Array<std::uint8_t> level_;  // of each vertex: how often edges were halved for it
  Array<std::uint8_t> drawn_;  // of each arc
  Array<double> cost_;         // of each arc, with nothing drawn
  base::Heap<Waiting> waiting_;
  std::size_t drawn_count_ = 0;
  Array<Index> starts_, ends_;
  double diagonal_ = 0;
  std::size_t max_faces_ = 0;
};

}  // namespace

Drawing trace(const Layout& layout, const LayoutGuide& guide, EditableSurface& surface, const base::Host& host) {
  return Tracing(layout, guide, surface, host).run();
}

Drawing trace(const Layout& layout, EditableSurface& surface, const base::Host& host) {
  return trace(layout, straight_guide(layout, host.memory), surface, host);
}

}  // namespace orbicube::polycube
