#include "polycube/unfolded_corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "mesh/predicates.h"

namespace orbicube::polycube {
namespace {

constexpr const char* phase = "corners";
constexpr double infinite = std::numeric_limits<double>::infinity();

class CornerMoves {
 public:
  CornerMoves(UnfoldedMap& map, const TriangleWeights& weights, const base::Host& host)
      : map_(map),
        surface_(map.surface),
        weights_(weights),
        host_(host),
        star_(host.memory),
        motions_(host.memory),
        best_(host.memory) {}

  // Several edges at once where meshes are fine.
  std::size_t run() {
    constexpr int most_edges = 8;
    std::size_t moves = 0;
    for (Index corner = 0; corner < map_.corners.size(); ++corner) {
      host_.report(phase, corner, map_.corners.size());
      for (int i = 0; i < most_edges && move(corner); ++i)
        ++moves;
    }
    return moves;
  }

 private:
  // To the end of the half-edge; the vertex that is left goes to `place`, in the plane of the second triangle around
  // it.
  struct Move {
    Index half_edge = no_index;
    double gain = 0;
    Vector2d place = Vector2d::Zero();
  };

  double triangle_energy(Index p, Index q, Index r, const Vector2d& a, const Vector2d& b, const Vector2d& c) const {
    if (mesh::orientation_2d(a, b, c) <= 0) return infinite;
    const RestTriangle rest = weights_.rest(surface_, p, q, r);
    return weights_.weight(rest) * distortion(jacobian(rest, a, b, c));
  }
  double energy_of(Index f) const {
    const Triangle& t = surface_.triangle[f];
    return triangle_energy(t[0], t[1], t[2], map_.at(3 * f), map_.at(3 * f + 1), map_.at(3 * f + 2));
  }

  bool move(Index number) {
    const Index v = map_.corners[number].vertex;
    Move best;
    double around = 0;
    surface_.for_each_outgoing(v, [&](Index h) { around += energy_of(h / 3); });
    // What is gained must be worth it, or corners go to and fro.
    constexpr double least_gain = 1e-3;
    surface_.for_each_outgoing(v, [&](Index h) {
      const Move found = evaluate(h, around);
      if (found.half_edge == no_index || found.gain <= std::max(best.gain, least_gain * around)) return;
      best = found;
      std::swap(best_, motions_);
    });
    if (best.half_edge == no_index) return false;
    carry_out(number, best);
    return true;
  }

  // Triangles around the start of h counter-clockwise, the first one on the left of h: to the plane of each from that
  // of the second, without crossing h.
  void find_motions(Index h) {
    const Index second = surface_.turned(h);
    motions_.clear();
    motions_.push_back(map_.across(second));
    motions_.push_back({});
    for (Index x = second; surface_.turned(x) != h; x = surface_.turned(x))
      motions_.push_back(map_.across(EditableSurface::previous(x)).after(motions_.back()));
  }

  Move evaluate(Index h, double around) {
    const Index v = surface_.start(h), w = surface_.end(h), g = surface_.opposite(h);
    Move result;
    if (map_.is_corner(w)) return result;
    // The triangles at w alone, with w where the corner is.
    const Vector2d corner_at_w = map_.motion[EditableSurface::next(h)].inverse()(map_.at(h));
    double before = around, after = 0;
    surface_.for_each_outgoing(w, [&](Index x) {
      if (x / 3 == h / 3 || x / 3 == g / 3) return;
      before += energy_of(x / 3);
      after += triangle_energy(w, surface_.end(x), surface_.end(EditableSurface::next(x)), map_.motion[x](corner_at_w),
                               map_.at(EditableSurface::next(x)), map_.at(EditableSurface::previous(x)));
    });
    if (!(after < before)) return result;
    // The triangles at v, unfolded around it and cut open along h.
    find_motions(h);
    star_.triangles.clear();
    Vector2d middle = Vector2d::Zero();
    Index x = h;
    for (const PlaneMotion& motion : motions_) {
      const PlaneMotion back = motion.inverse();
      const Index next = EditableSurface::next(x), previous = EditableSurface::previous(x);
      const auto seen = [&](Index y) { return back(map_.at(surface_.start(y) == w ? x : y)); };
      UnfoldedStar::Corner t{weights_.rest(surface_, v, surface_.start(next), surface_.start(previous)), seen(next),
                             seen(previous), 0};
      t.weight = weights_.weight(t.rest);
      middle += t.a;
      star_.triangles.push_back(t);
      x = surface_.turned(x);
    }
    middle /= static_cast<double>(motions_.size());
    const Vector2d from = map_.at(surface_.turned(h));
    double least = infinite;
    for (double part = 0.6; part > 0.01; part *= 0.5) {
      const Vector2d place = from + part * (middle - from);
      if (!star_.positive(place)) continue;
      const double energy = star_.energy(place);
      if (energy >= least) continue;
      least = energy;
      result.place = place;
    }
    if (!std::isfinite(least)) return result;
    constexpr int steps = 4;
    double last = 0, gained = 0;
    for (int k = 0; k < steps; ++k)
      result.place = star_.improved(result.place, last, gained);
    result.gain = before - after - star_.energy(result.place);
    if (result.gain > 0 && turns_once(result.place)) result.half_edge = h;
    return result;
  }

  bool turns_once(const Vector2d& place) const {
    double angle = 0;
    for (const UnfoldedStar::Corner& t : star_.triangles) {
      const Vector2d a = t.a - place, b = t.b - place;
      angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    }
    return std::abs(angle - 2 * std::numbers::pi) < 1;
  }

  void carry_out(Index number, const Move& move) {
    const Index h = move.half_edge, v = surface_.start(h), w = surface_.end(h);
    UnfoldedCorner& corner = map_.corners[number];
    // The direction of the next edge, seen from the corner, is the same from either triangle beside it, and from v or
    // w.
    const Index beside = surface_.end(EditableSurface::next(h));
    map_.follow(corner);  // other corners may have moved since
    double angle = corner.angle;
    for (Index y = surface_.between(v, corner.end); surface_.end(y) != beside; y = surface_.turned(y))
      angle += map_.angle_at(y);
    const Vector2d direction = map_.at(EditableSurface::previous(h)) - map_.at(h);
    map_.image[w] = map_.motion[EditableSurface::next(h)].inverse()(map_.at(h));
    map_.image[v] = move.place;
    Index x = h;
    for (const PlaneMotion& motion : best_) {
      map_.motion[x] = motion;
      x = surface_.turned(x);
    }
    map_.corner_at[v] = no_index;
    map_.corner_at[w] = number;
    corner.vertex = w;
    corner.end = beside;
    corner.angle = angle;
    corner.direction = direction;
  }

  UnfoldedMap& map_;
  EditableSurface& surface_;
  const TriangleWeights& weights_;
  const base::Host& host_;
  UnfoldedStar star_;
  Array<PlaneMotion> motions_, best_;  // of the triangles around the corner that is looked at, and of the best move
};

}  // namespace

std::size_t move_corners(UnfoldedMap& map, const TriangleWeights& weights, const base::Host& host) {
  return CornerMoves(map, weights, host).run();
}

}  // namespace orbicube::polycube
