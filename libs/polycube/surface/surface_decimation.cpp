#include "polycube/surface/surface_decimation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/heap.h"
#include "polycube/surface/quadric.h"

namespace orbicube::polycube {
namespace {

constexpr const char* surface_decimation_phase = "decimation";

class SurfaceDecimation {
 public:
  SurfaceDecimation(const Layout& layout, EditableSurface& surface, const Drawing& drawing, const base::Host& host)
      : surface_(surface),
        host_(host),
        is_node_(surface.vertices(), 0, host.memory),
        is_corner_(surface.vertices(), 0, host.memory),
        quadrics_(surface.vertices(), host.memory),
        version_(surface.vertices(), 0, host.memory),
        queue_(host.memory),
        collapsed_(host.memory),
        around_(host.memory) {
    for (const Index v : drawing.node_vertex)
      is_node_[v] = 1;
    for (Index n = 0; n < layout.nodes.size(); ++n)
      is_corner_[drawing.node_vertex[n]] = layout.nodes[n].corner;
    const Vector3 origin = surface.position[drawing.node_vertex[0]];
    origin_ = origin;
    for (Index f = 0; f < surface.faces(); ++f) {
      const Triangle& t = surface.triangle[f];
      const Vector3 p = at(t[0]);
      const Vector3 normal = (at(t[1]) - p).cross(at(t[2]) - p);
      const double twice = normal.norm();
      if (!(twice > 0)) continue;
      for (const Index v : t)
        quadrics_[v].add_plane(normal / twice, -normal.dot(p) / twice, twice);
    }
  }

  Array<Index> run(std::size_t min_vertices) {
    std::size_t left = 0;
    for (Index v = 0; v < surface_.vertices(); ++v) {
      if (v % 1024 == 0) host_.report(surface_decimation_phase, v, surface_.vertices());
      if (surface_.outgoing(v) == no_index) continue;
      ++left;
      push(v);
    }
    while (left > min_vertices && !queue_.empty()) {
      if (collapsed_.size() % 256 == 0) host_.report(surface_decimation_phase, 0, 0);
      const Candidate top = queue_.pop();
      if (version_[top.vertex] != top.version || surface_.outgoing(top.vertex) == no_index) continue;
      const Candidate best = cheapest(top.vertex);
      if (best.half_edge == no_index) continue;
      if (best.cost > top.cost * 1.0000001) {
        queue_.push(best);
        continue;
      }
      apply(best.half_edge);
      --left;
    }
    return std::move(collapsed_);
  }

 private:
  struct Candidate {
    double cost;
    Index vertex, half_edge;
    std::uint32_t version;

    bool operator>(const Candidate& other) const {
      return cost != other.cost ? cost > other.cost : vertex > other.vertex;
    }
  };
  Vector3 at(Index v) const { return surface_.position[v] - origin_; }

  // What the drawing allows; surface_.can_collapse() is tested as well.
  bool allowed(Index h) const {
    const Index v = surface_.start(h), w = surface_.end(h);
    // Not into corners: beside one that a face goes around by 270 degrees, there may be no way back onto the edge.
    // Everywhere else a vertex put back sees its whole ring from close to where it went.
    if (surface_.occupied[v]) return surface_.arc[h] != no_index && !is_corner_[w];
    if (!surface_.occupied[w]) return true;
    const Index c = surface_.end(EditableSurface::next(h)),
                d = surface_.end(EditableSurface::next(surface_.opposite(h)));
    bool chord = false;
    surface_.for_each_outgoing(v, [&](Index x) {
      const Index n = surface_.end(x);
      if (n != w && n != c && n != d && surface_.occupied[n]) chord = true;
    });
    return !chord;
  }

  // Triangles of v turned by going to w, as the smallest cosine between their normals before and after.
  double turned(Index h) const {
    const Index w = surface_.end(h);
    double least = 1;
    surface_.for_each_outgoing(surface_.start(h), [&](Index x) {
      const Index a = surface_.end(x), b = surface_.start(EditableSurface::previous(x));
      if (a == w || b == w) return;
      const Vector3 pa = at(a), pb = at(b);
      const Vector3 before = (pa - at(surface_.start(h))).cross(pb - at(surface_.start(h)));
      const Vector3 after = (pa - at(w)).cross(pb - at(w));
      const double size = before.norm() * after.norm();
      if (size > 0) least = std::min(least, before.dot(after) / size);
    });
    return least;
  }

  Candidate cheapest(Index v) {
    Candidate best{std::numeric_limits<double>::infinity(), v, no_index, version_[v]};
    if (is_node_[v]) return best;
    int valence = 0;
    surface_.for_each_outgoing(v, [&](Index) { ++valence; });
    constexpr int max_valence = 24;
    if (valence > max_valence) return best;
    surface_.for_each_outgoing(v, [&](Index h) {
      if (!allowed(h)) return;
      const Index w = surface_.end(h);
      const double length = (at(w) - at(v)).squaredNorm();
      // A little of the edge's length keeps triangles round where the surface is flat.
      double cost = std::max(0.0, quadrics_[v].at(at(w))) + 1e-3 * length * length;
      // Folds are taken last.
      if (cost >= best.cost) return;
      if (turned(h) < 0.1) cost = cost * 1e3 + length * length;
      if (cost >= best.cost || !surface_.can_collapse(h)) return;
      best.cost = cost;
      best.half_edge = h;
    });
    return best;
  }

  void push(Index v) {
    const Candidate best = cheapest(v);
    if (best.half_edge != no_index) queue_.push(best);
  }

  void apply(Index h) {
    const Index v = surface_.start(h), w = surface_.end(h);
    around_.clear();
    surface_.for_each_outgoing(v, [&](Index x) { around_.push_back(surface_.end(x)); });
    surface_.collapse(h);
    quadrics_[w].add(quadrics_[v]);
    collapsed_.push_back(h);
    for (const Index n : around_) {
      ++version_[n];
      push(n);
    }
  }

  EditableSurface& surface_;
  const base::Host& host_;
  Vector3 origin_ = Vector3::Zero();
  Array<std::uint8_t> is_node_, is_corner_;
  Array<Quadric> quadrics_;
  Array<std::uint32_t> version_;
  base::Heap<Candidate> queue_;
  Array<Index> collapsed_;
  Array<Index> around_;
};

}  // namespace

Array<Index> decimate(const Layout& layout, EditableSurface& surface, const Drawing& drawing, std::size_t min_vertices,
                      const base::Host& host) {
  return SurfaceDecimation(layout, surface, drawing, host).run(min_vertices);
}

}  // namespace orbicube::polycube
