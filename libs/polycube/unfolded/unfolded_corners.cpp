#include "polycube/unfolded/unfolded_corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/heap.h"
#include "base/infinity.h"
#include "mesh/search/predicates.h"

namespace orbicube::polycube {
namespace {

constexpr const char* unfolded_corners_phase = "corners";

class CornerMoves {
 public:
  CornerMoves(UnfoldedMap& map, const TriangleWeights& weights, const base::Host& host)
      : map_(map),
        surface_(map.surface),
        weights_(weights),
        host_(host),
        star_(host.memory),
        distance_(host.memory),
        first_(host.memory),
        near_(host.memory),
        motions_(host.memory),
        best_(host.memory) {}

  // Several edges at once where meshes are fine.
  std::size_t run() {
    constexpr int max_edges = 8;
    std::size_t moves = 0;
    for (Index corner = 0; corner < map_.corners.size(); ++corner) {
      host_.report(unfolded_corners_phase, corner, map_.corners.size());
      if (map_.corners[corner].held) continue;
      for (int i = 0; i < max_edges && move(corner); ++i)
        ++moves;
    }
    return moves;
  }

  // By the shortest way on the polycube. It is looked for again after each move.
  bool walk(Index number, Index goal) {
    constexpr int max_tries = 6, passes = 4;
    int tries = 0;
    while (map_.corners[number].vertex != goal) {
      host_.report(unfolded_corners_phase, 0, 0);
      const Index v = map_.corners[number].vertex, h = toward(v, goal);
      if (h == no_index) return false;
      const Move found = evaluate(h, energy_around(v), goal, true);
      if (found.half_edge == no_index) {
        if (++tries > max_tries) return false;
      } else {
        std::swap(best_, motions_);
        carry_out(number, found);
        tries = 0;
      }
      relax_around(map_.corners[number].vertex, passes << tries);
      map_.follow_corners();
    }
    return true;
  }

  // To the neighbor where that gains most, or costs least.
  bool leave(Index number) {
    const Index v = map_.corners[number].vertex;
    const double around = energy_around(v);
    Move best;
    surface_.for_each_outgoing(v, [&](Index h) {
      const Move found = evaluate(h, around, no_index, true);
      if (found.half_edge == no_index || (best.half_edge != no_index && found.gain <= best.gain)) return;
      best = found;
      std::swap(best_, motions_);
    });
    if (best.half_edge == no_index) return false;
    carry_out(number, best);
    return true;
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
    if (mesh::orientation_2d(a, b, c) <= 0) return base::infinity;
    const RestTriangle rest = weights_.rest(surface_, p, q, r);
    return weights_.weight(rest) * untangle::barrier(jacobian(rest, a, b, c));
  }
  double energy_of(Index f) const {
    const Triangle& t = surface_.triangle[f];
    return triangle_energy(t[0], t[1], t[2], map_.at(3 * f), map_.at(3 * f + 1), map_.at(3 * f + 2));
  }

  double energy_around(Index v) const {
    double sum = 0;
    surface_.for_each_outgoing(v, [&](Index h) { sum += energy_of(h / 3); });
    return sum;
  }

  // The first half-edge of the way from v, past corners and what is fixed.
  Index toward(Index v, Index goal) {
    distance_.assign(surface_.vertices(), base::infinity);
    first_.assign(surface_.vertices(), no_index);
    // From the goal, so that the way is known where it ends.
    using Entry = std::pair<double, Index>;
    base::Heap<Entry> heap(host_.memory);
    distance_[goal] = 0;
    heap.push({0, goal});
    while (!heap.empty()) {
      const Entry nearest = heap.pop();
      const double length = nearest.first;
      const Index at = nearest.second;
      if (at == v) break;
      if (length > distance_[at]) continue;
      surface_.for_each_outgoing(at, [&](Index h) {
        const Index to = surface_.end(h);
        if (to != v && (map_.is_corner(to) || !map_.is_free(to))) return;
        const double there = length + surface_.length(h);
        if (!(there < distance_[to])) return;
        distance_[to] = there;
        first_[to] = surface_.opposite(h);
        heap.push({there, to});
      });
    }
    return first_[v];
  }

  // Vertices up to two edges away, one after the other.
  void relax_around(Index v, int passes) {
    near_.clear();
    near_.push_back(Index{v});
    for (std::size_t ring = 0, begin = 0; ring < 3; ++ring) {
      const std::size_t end = near_.size();
      for (; begin < end; ++begin)
        surface_.for_each_outgoing(near_[begin], [&](Index h) {
          const Index to = surface_.end(h);
          if (std::find(near_.begin(), near_.end(), to) == near_.end()) near_.push_back(Index{to});
        });
    }
    for (int pass = 0; pass < passes; ++pass) {
      for (const Index u : near_) {
        if (map_.is_corner(u) || map_.held[u] == 3) continue;
        star_.gather(map_, weights_, u);
        double before = 0, gain = 0;
        map_.image[u] = star_.improved(map_.image[u], before, gain);
      }
    }
  }

  bool move(Index number) {
    const Index v = map_.corners[number].vertex;
    Move best;
    const double around = energy_around(v);
    // What is gained must be worth it, or corners go to and fro.
    constexpr double min_gain = 1e-3;
    surface_.for_each_outgoing(v, [&](Index h) {
      const Move found = evaluate(h, around);
      if (found.half_edge == no_index || found.gain <= std::max(best.gain, min_gain * around)) return;
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

  // `goal` may be tied. Where it is forced, a move that gains nothing will do.
  Move evaluate(Index h, double around, Index goal = no_index, bool forced = false) {
    const Index v = surface_.start(h), w = surface_.end(h), g = surface_.opposite(h);
    Move result;
    if (map_.is_corner(w) || (w != goal && !map_.is_free(w))) return result;
    // The triangles at w alone, with w where the corner is.
    const Vector2d corner_at_w = map_.motion[EditableSurface::next(h)].inverse()(map_.at(h));
    double before = around, after = 0;
    surface_.for_each_outgoing(w, [&](Index x) {
      if (x / 3 == h / 3 || x / 3 == g / 3) return;
      before += energy_of(x / 3);
      after += triangle_energy(w, surface_.end(x), surface_.end(EditableSurface::next(x)), map_.motion[x](corner_at_w),
                               map_.at(EditableSurface::next(x)), map_.at(EditableSurface::previous(x)));
    });
    if (!(after < (forced ? base::infinity : before))) return result;
    // The triangles at v, unfolded around it and cut open along h.
    find_motions(h);
    star_.triangles.clear();
    star_.held = 0;
    star_.tie = nullptr;
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
    double least = base::infinity;
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
    if ((forced || result.gain > 0) && turns_once(result.place)) result.half_edge = h;
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
    map_.held[w] = 0;
    map_.tie_at[w] = no_index;
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
  Array<double> distance_;  // of each vertex from the end of a walk
  Array<Index> first_, near_;
  Array<PlaneMotion> motions_, best_;  // of the triangles around the corner that is looked at, and of the best move
};

}  // namespace

std::size_t move_corners(UnfoldedMap& map, const TriangleWeights& weights, const base::Host& host) {
  return CornerMoves(map, weights, host).run();
}

bool walk_corner(UnfoldedMap& map, const TriangleWeights& weights, Index corner, Index vertex, const base::Host& host) {
  return CornerMoves(map, weights, host).walk(corner, vertex);
}

bool leave_vertex(UnfoldedMap& map, const TriangleWeights& weights, Index corner, const base::Host& host) {
  return CornerMoves(map, weights, host).leave(corner);
}

}  // namespace orbicube::polycube
