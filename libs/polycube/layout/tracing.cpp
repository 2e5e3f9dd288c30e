#include "polycube/layout/tracing.h"

#include <algorithm>

#include "base/error.h"
#include "base/heap.h"
#include "mesh/topology/disjoint_sets.h"
#include "polycube/layout/arc_routes.h"

namespace orbicube::polycube {
namespace {

constexpr const char* tracing_phase = "tracing";

// Which arc is drawn when.
class Tracing {
 public:
  Tracing(const Layout& layout, const LayoutGuide& guide, EditableSurface& surface, const base::Host& host)
      : layout_(layout),
        host_(host),
        drawing_(layout, surface, host),
        routes_(layout, guide, surface, drawing_, host),
        cost_(layout.arcs(), 0.0, host.memory),
        waiting_(host.memory) {
    drawing_.refine_for_nodes();
    drawing_.place_nodes(guide);
  }

  Drawing run() {
    measure_arcs();
    draw_tree();
    draw_rest();
    return drawing_.take();
  }

 private:
  // Arcs that wait to be drawn, the cheapest first. What is drawn only makes the others costlier, so an arc that was
  // priced before is priced again when its turn comes, and goes back if it is no longer the cheapest.
  struct Waiting {
    double cost;
    Index arc;

    bool operator>(const Waiting& other) const { return cost != other.cost ? cost > other.cost : arc > other.arc; }
  };

  void measure_arcs() {
    for (Index arc = 0; arc < layout_.arcs(); ++arc) {
      host_.report(tracing_phase, 0, 0);
      cost_[arc] = routes_.find(arc, false);
    }
  }

  // Takes arcs off the queue until the first has the cost that it is there for; draws that.
  template <class Wanted>
  Index draw_cheapest(bool generators, const Wanted& wanted) {
    while (!waiting_.empty()) {
      host_.report(tracing_phase, drawing_.drawn_count(), layout_.arcs());
      const Index arc = waiting_.pop().arc;
      if (!wanted(arc)) continue;
      const double cost = routes_.find(arc, generators);
      if (!waiting_.empty() && cost > waiting_.top().cost * (1 + 1e-12)) {
        waiting_.push({cost, arc});
        continue;
      }
      drawing_.draw(arc);
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
      if (!drawing_.drawn(arc)) rest.push_back(arc);
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

  const Layout& layout_;
  const base::Host& host_;
  LayoutDrawing drawing_;
  ArcRoutes routes_;
  Array<double> cost_;  // of each arc, with nothing drawn
  base::Heap<Waiting> waiting_;
};

// Floods the rectangles from the arcs.
void label_rectangles(const Layout& layout, const EditableSurface& surface, Drawing& drawing, const base::Host& host) {
  drawing.rectangle.assign(surface.faces(), no_index);
  Array<Index> waiting(host.memory);
  for (Index dart = 0; dart < 2 * layout.arcs(); ++dart) {
    const auto& path = drawing.path[dart / 2];
    const std::size_t n = path.size();
    const Index h = dart % 2 == 0 ? surface.between(path[0], path[1]) : surface.between(path[n - 1], path[n - 2]);
    const Index rectangle = layout.dart_left[dart];
    Index& here = drawing.rectangle[h / 3];
    if (here != no_index && here != rectangle) throw base::Error("internal", "two rectangles in one region");
    if (here == rectangle) continue;
    here = rectangle;
    waiting.push_back(h / 3);
    while (!waiting.empty()) {
      const Index f = waiting.back();
      waiting.pop_back();
      for (Index k = 0; k < 3; ++k) {
        const Index across = surface.opposite(3 * f + k) / 3;
        if (surface.arc[3 * f + k] != no_index || drawing.rectangle[across] != no_index) continue;
        drawing.rectangle[across] = rectangle;
        waiting.push_back(across);
      }
    }
  }
}

// Throws unless each rectangle is a disk.
void require_disks(const Layout& layout, const EditableSurface& surface, const Drawing& drawing,
                   const base::Host& host) {
  // Euler numbers: interior vertices - interior edges + faces = 1 for an open disk.
  Array<std::int64_t> euler(layout.rectangles.size(), 0, host.memory);
  for (Index f = 0; f < surface.faces(); ++f) {
    if (drawing.rectangle[f] == no_index) throw base::Error("internal", "a part of the surface without rectangle");
    ++euler[drawing.rectangle[f]];
    for (Index k = 0; k < 3; ++k)
      if (surface.arc[3 * f + k] == no_index && 3 * f + k < surface.opposite(3 * f + k)) --euler[drawing.rectangle[f]];
  }
  for (Index v = 0; v < surface.vertices(); ++v)
    if (!surface.occupied[v] && surface.outgoing(v) != no_index) ++euler[drawing.rectangle[surface.outgoing(v) / 3]];
  if (std::any_of(euler.begin(), euler.end(), [](std::int64_t e) { return e != 1; }))
    throw base::Error("internal", "a rectangle that is no disk");
}

}  // namespace

Drawing trace(const Layout& layout, const LayoutGuide& guide, EditableSurface& surface, const base::Host& host) {
  Drawing drawing = Tracing(layout, guide, surface, host).run();
  label_rectangles(layout, surface, drawing, host);
  require_disks(layout, surface, drawing, host);
  return drawing;
}

Drawing trace(const Layout& layout, EditableSurface& surface, const base::Host& host) {
  return trace(layout, straight_guide(layout, host.memory), surface, host);
}

}  // namespace orbicube::polycube
