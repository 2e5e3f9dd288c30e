#include "polycube/surface/added_vertices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "base/infinity.h"
#include "mesh/search/predicates.h"
#include "polycube/surface/input_sides.h"

namespace orbicube::polycube {
namespace {

constexpr const char* added_vertices_phase = "map";

class Removal {
 public:
  Removal(EditableSurface& surface, const MapView& map, const base::Host& host)
      : surface_(surface), map_(map), host_(host), sides_(surface, host.memory) {}

  std::size_t run() {
    // What goes makes room for others.
    constexpr int max_rounds = 10;
    std::size_t removed = 0;
    for (int round = 0; round < max_rounds; ++round) {
      const std::size_t before = removed;
      for (Index v = 0; v < surface_.vertices(); ++v) {
        if (v % 256 == 0) host_.report(added_vertices_phase, 0, 0);
        if (surface_.outgoing(v) == no_index || surface_.source[v].corner[1] == no_index) continue;
        const Index h = best_collapse(v);
        if (h == no_index) continue;
        surface_.collapse(h);
        ++removed;
      }
      if (removed == before) break;
    }
    return removed;
  }

 private:
  bool on_polycube_edge(Index h) const { return map_.facet[h / 3] != map_.facet[surface_.opposite(h) / 3]; }

  // Of a triangle with its first corner moved: by how much its distortions exceed an isometry's; infinite when it
  // would not be positive.
  double excess(Index face, Index a, Index b, Index c) const {
    const auto axis = static_cast<std::size_t>(axis_of(map_.label[face]));
    const double sign = sign_of(map_.label[face]);
    const auto flat = [&](Index v) {
      const Vector3& p = map_.image[v];
      return Vector2d(p[static_cast<Eigen::Index>((axis + 1) % 3)],
                      sign * p[static_cast<Eigen::Index>((axis + 2) % 3)]);
    };
    const Vector2d u = flat(a), v = flat(b), w = flat(c);
    if (mesh::orientation_2d(u, v, w) <= 0) return base::infinity;
    const auto& p = surface_.position;
    const double in_space = map_.scale * map_.scale * 0.5 * (p[b] - p[a]).cross(p[c] - p[a]).norm();
    const double on_polycube = 0.5 * ((v - u).x() * (w - u).y() - (v - u).y() * (w - u).x());
    if (!(in_space > 0) || !(on_polycube > 0)) return base::infinity;
    const double squares = (p[b] - p[a]).dot(p[c] - p[a]) * (v - w).squaredNorm() +
                           (p[c] - p[b]).dot(p[a] - p[b]) * (w - u).squaredNorm() +
                           (p[a] - p[c]).dot(p[b] - p[c]) * (u - v).squaredNorm();
    const double angle = map_.scale * map_.scale * squares / (8 * in_space * on_polycube);
    const double ratio = on_polycube / in_space;
    return angle + 0.5 * (ratio + 1 / ratio) - 2;
  }

  Index best_collapse(Index v) const {
    double now = 0;
    int edges = 0;  // of the polycube, at v
    surface_.for_each_outgoing(v, [&](Index h) {
      edges += on_polycube_edge(h);
      now += excess(h / 3, v, surface_.end(h), surface_.end(EditableSurface::next(h)));
    });
    if (edges > 2) return no_index;
    double least = now;
    Index best = no_index;
    surface_.for_each_outgoing(v, [&](Index h) {
      const Index w = surface_.end(h);
      if (!sides_.along(v, w) || (edges > 0 && !on_polycube_edge(h))) return;
      double sum = 0;
      surface_.for_each_outgoing(v, [&](Index x) {
        const Index a = surface_.end(x), b = surface_.end(EditableSurface::next(x));
        if (a == w || b == w || sum >= least) return;
        sum += sides_.up(x / 3, w, a, b) ? excess(x / 3, w, a, b) : std::numeric_limits<double>::infinity();
      });
      if (!(sum < least) || !surface_.can_collapse(h)) return;
      least = sum;
      best = h;
    });
    return best;
  }

  EditableSurface& surface_;
  const MapView& map_;
  const base::Host& host_;
  const InputSides sides_;
};

}  // namespace

std::size_t remove_added_vertices(EditableSurface& surface, const MapView& map, const base::Host& host) {
  return Removal(surface, map, host).run();
}

}  // namespace orbicube::polycube
