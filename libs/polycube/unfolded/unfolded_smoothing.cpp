#include "polycube/unfolded/unfolded_smoothing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "mesh/search/predicates.h"
#include "polycube/surface/input_sides.h"
#include "polycube/unfolded/unfolded_corners.h"
#include "polycube/unfolded/unfolded_newton.h"

namespace orbicube::polycube {
namespace {

constexpr const char* unfolded_smoothing_phase = "smoothing";

class Smoothing {
 public:
  Smoothing(UnfoldedMap& map, const base::Host& host)
      : map_(map),
        surface_(map.surface),
        host_(host),
        weights_(map),
        star_(host.memory),
        sides_(map.surface, host.memory) {}

  int run(const SmoothingOptions& options) {
    constexpr int max_removals = 12, steps_at_once = 40, steps_between = 10;
    constexpr double fine = 1e-4;
    for (int i = 0; i < max_removals; ++i) {
      sweep(i == 0 ? 60 : 6);
      if (remove_added() == 0) break;
    }
    int left = options.newton_steps;
    const auto move = [&](int steps, double min_gain) {
      left -= move_all(map_, weights_, std::min(steps, left), min_gain, host_);
    };
    // Corners are led astray by what is not settled. Where the budget is small, as on large surfaces, single vertices
    // have to settle what moved corners leave: steps of all vertices between rounds would take half of the time.
    move(steps_at_once, fine);
    for (int i = 0; i < options.corner_rounds && left > 0; ++i) {
      const std::size_t moved = move_corners(map_, weights_, host_);
      const std::size_t removed = remove_added();
      if (moved + removed == 0) break;
      sweep(6);
      if (left > steps_at_once) move(steps_between, fine);
    }
    move(steps_at_once, fine);
    return options.newton_steps - left;
  }

 private:
  // One vertex after the other, forwards and backwards, until that gains little. A few bad triangles keep all vertices
  // together from moving far, but not their own.
  void sweep(int most) {
    constexpr double little = 0.01;
    const auto count = static_cast<Index>(surface_.vertices());
    for (int i = 0; i < most; ++i) {
      double energy = 0, gain = 0;
      for (Index k = 0; k < count; ++k) {
        if (k % 256 == 0) host_.report(unfolded_smoothing_phase, 0, 0);
        const Index v = i % 2 == 0 ? k : count - 1 - k;
        if (surface_.outgoing(v) == no_index || map_.is_corner(v) || map_.held[v] == 3) continue;
        star_.gather(map_, weights_, v);
        double before = 0, fallen = 0;
        map_.image[v] = star_.improved(map_.image[v], before, fallen);
        energy += before;
        gain += fallen;
      }
      map_.follow_corners();
      // Every triangle is in three stars.
      if (gain < little * energy / 3) break;
    }
  }

  // The half-edge to the neighbor into which the vertex is best merged; no_index when none makes it better.
  Index best_collapse(Index v) {
    constexpr double isometry = 2;
    star_.gather(map_, weights_, v);
    double now = 0;
    for (const UnfoldedStar::Corner& t : star_.triangles)
      now += untangle::barrier(jacobian(t.rest, map_.image[v], t.a, t.b)) - isometry;
    double least = now;
    Index best = no_index;
    surface_.for_each_outgoing(v, [&](Index h) {
      const Index w = surface_.end(h);
      if (!sides_.along(v, w)) return;
      const Vector2d there = map_.motion[h].inverse()(map_.at(EditableSurface::next(h)));
      double sum = 0;
      std::size_t i = 0;
      surface_.for_each_outgoing(v, [&](Index x) {
        const UnfoldedStar::Corner& t = star_.triangles[i++];
        const Index a = surface_.end(x), b = surface_.end(EditableSurface::next(x));
        if (a == w || b == w || sum >= least) return;
        if (!sides_.up(x / 3, w, a, b) || mesh::orientation_2d(there, t.a, t.b) <= 0)
          sum = std::numeric_limits<double>::infinity();
        else
          sum += untangle::barrier(jacobian(weights_.rest(surface_, w, a, b), there, t.a, t.b)) - isometry;
      });
      if (!(sum < least) || !surface_.can_collapse(h)) return;
      least = sum;
      best = h;
    });
    return best;
  }

  std::size_t remove_added() {
    std::size_t removed = 0;
    for (Index v = 0; v < surface_.vertices(); ++v) {
      if (v % 256 == 0) host_.report(unfolded_smoothing_phase, 0, 0);
      if (surface_.outgoing(v) == no_index || map_.is_corner(v) || surface_.source[v].corner[1] == no_index) continue;
      if (!map_.is_free(v)) continue;
      const Index h = best_collapse(v);
      if (h == no_index) continue;
      map_.collapse(h);
      ++removed;
    }
    if (removed > 0) weights_ = TriangleWeights(map_);
    return removed;
  }

  UnfoldedMap& map_;
  EditableSurface& surface_;
  const base::Host& host_;
  TriangleWeights weights_;
  UnfoldedStar star_;
  const InputSides sides_;
};

}  // namespace

int smooth_unfolded(UnfoldedMap& map, const SmoothingOptions& options, const base::Host& host) {
  return Smoothing(map, host).run(options);
}

}  // namespace orbicube::polycube
