#include "hexmesh/quality/hex_reach.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/grouping.h"
#include "hexmesh/quality/hex_moves.h"
#include "mesh/search/nearest.h"

namespace orbicube::hexmesh {
namespace {

class Reach {
 public:
  Reach(HexMesh& mesh, const HexBoundary& boundary, const SurfaceTarget& target, double distance,
        const base::Host& host)
      : mesh_(mesh),
        boundary_(boundary),
        target_(target),
        distance_(distance),
        host_(host),
        moves_(mesh, boundary, host),
        halves_(halves_of(mesh.quads, host.memory)),
        around_(base::cells_around(std::span<const mesh::Triangle>(halves_), mesh.positions.size(), host.memory)),
        samples_(host.memory),
        inner_(host.memory),
        saved_(host.memory) {}

  void run() {
    find_samples();
    Array<Ward> wards(host_.memory);
    // Hexahedra lose as little as will do.
    for (const double quality : {0.5, 0.3, 0.15}) {
      floor_ = quality;
      constexpr int max_passes = 20;
      for (int pass = 0; pass < max_passes; ++pass) {
        if (share_out(wards) <= near_enough * distance_) return;
        bool any = false;
        for (std::size_t begin = 0, end = 0; begin < wards.size(); begin = end) {
          while (end < wards.size() && wards[end].vertex == wards[begin].vertex)
            ++end;
          host_.report("reach", static_cast<std::uint64_t>(pass), max_passes);
          any |= reach(wards[begin].vertex, std::span(wards).subspan(begin, end - begin));
        }
        if (!any) break;
      }
    }
  }

 private:
  static constexpr double near = 0.85;         // of the distance: samples nearer than that are left alone
  static constexpr double near_enough = 0.95;  // nothing is done when all are nearer than that
  static constexpr double watched = 0.6;       // of the distance: what is farther may become too far by what is moved
  static constexpr double spacing = 0.2;       // of samples, in cells
  static constexpr double min_gain = 1e-4;

  // A sample that a vertex of the boundary stands for, as a corner of the nearest half of a quad.
  struct Ward {
    Index vertex, sample;
    double gap;
    Vector3 way;  // to the sample
    bool operator<(const Ward& other) const {
      return std::pair(vertex, sample) < std::pair(other.vertex, other.sample);
    }
  };

  // Points of the surface that are far from the boundary.
  void find_samples() {
    constexpr double max_parts = 60;
    const mesh::SurfaceSearch search(mesh_.positions, halves_, host_);
    Index last = no_index;
    std::size_t count = 0;
    for (const mesh::Triangle& t : target_.triangles()) {
      if (count++ % 64 == 0) host_.report("reach", 0, 0);
      const Vector3 a = target_.positions()[t[0]], b = target_.positions()[t[1]] - a, c = target_.positions()[t[2]] - a;
      const double longest = std::sqrt(std::max({b.squaredNorm(), c.squaredNorm(), (c - b).squaredNorm()}));
      const int parts = static_cast<int>(std::clamp(std::ceil(longest / spacing), 1.0, max_parts));
      for (int k = 0; k <= parts; ++k) {
        for (int l = 0; k + l <= parts; ++l) {
          const Vector3 x = a + (k * b + l * c) / parts;
          if (last != no_index && search.distance(last, x) < watched * distance_) continue;
          const mesh::SurfacePoint found = search.nearest(x, last);
          last = found.triangle;
          if (found.distance > watched * distance_) samples_.push_back(x);
        }
      }
    }
  }

  // Samples to the vertices of what is nearest to them, by vertices. Returns how far the farthest is.
  double share_out(Array<Ward>& wards) const {
    const mesh::SurfaceSearch search(mesh_.positions, halves_, host_);
    wards.clear();
    double farthest = 0;
    for (Index i = 0; i < samples_.size(); ++i) {
      if (i % 64 == 0) host_.report("reach", 0, 0);
      const mesh::SurfacePoint found = search.nearest(samples_[i]);
      farthest = std::max(farthest, found.distance);
      for (const Index v : halves_[found.triangle])
        wards.push_back({v, i, found.distance, samples_[i] - found.position});
    }
    std::sort(wards.begin(), wards.end());
    return farthest;
  }

  // How far the farthest of these is from the quads around a vertex; not computed to the end where that is more than
  // `limit`.
  double gap(Index v, std::span<const Ward> wards, double limit) const {
    double farthest = 0;
    for (const Ward& ward : wards) {
      const Vector3& x = samples_[ward.sample];
      double least = std::numeric_limits<double>::infinity();
      for (const Index half : around_[v]) {
        const mesh::Triangle& t = halves_[half];
        const mesh::TrianglePoint at =
            mesh::nearest_on_triangle(x, mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]]);
        least = std::min(least, (at.position - x).squaredNorm());
      }
      farthest = std::max(farthest, std::sqrt(least));
      if (farthest > limit) break;
    }
    return farthest;
  }

  // Moves a vertex nearer to all of its samples. Returns whether it did.
  bool reach(Index v, std::span<const Ward> wards) {
    constexpr int straight_trials = 6, random_trials = 6;
    const Ward& worst =
        *std::max_element(wards.begin(), wards.end(), [](const Ward& a, const Ward& b) { return a.gap < b.gap; });
    if (worst.gap < near * distance_) return false;
    Vector3& x = mesh_.positions[v];
    // Others may have moved since.
    double now = gap(v, wards, std::numeric_limits<double>::infinity());
    choose_inner(v);
    double before = std::min(floor_, worst_of_chosen(v));
    bool any = false;
    for (int trial = 0; trial < straight_trials + random_trials; ++trial) {
      const Vector3 from = x;
      const Vector3 move = trial < straight_trials ? Vector3(std::pow(0.5, trial) * worst.way)
                                                   : Vector3(0.5 * worst.gap * moves_.random_direction());
      x = boundary_.project(v, from + move).position;
      const double then = gap(v, wards, now);
      if (then < now - min_gain && (moves_.worst_around(v, before) >= before || make_room(v, before))) {
        now = then;
        any = true;
        before = std::min(floor_, worst_of_chosen(v));
      } else {
        x = from;
      }
    }
    return any;
  }

  // The vertices inside that hexahedra around this one have.
  void choose_inner(Index v) {
    inner_.clear();
    for (const Index h : moves_.around(v)) {
      for (const Index w : mesh_.hexahedra[h]) {
        if (boundary_.kind(w) == HexBoundary::Kind::inside) inner_.push_back(w);
      }
    }
    std::sort(inner_.begin(), inner_.end());
    inner_.erase(std::unique(inner_.begin(), inner_.end()), inner_.end());
  }

  double worst_of_chosen(Index v) const {
    double worst = moves_.worst_around(v, HexMoves::lowest);
    for (const Index w : inner_)
      worst = std::min(worst, moves_.worst_around(w, HexMoves::lowest));
    return worst;
  }

  // Moves those inside until all around is at least so good, or puts them back. Returns whether it is.
  bool make_room(Index v, double wanted) {
    constexpr int rounds = 4;
    constexpr double radius = 0.2, good = 0.4;
    saved_.clear();
    for (const Index w : inner_)
      saved_.push_back(mesh_.positions[w]);
    for (int round = 0; round < rounds; ++round) {
      for (const Index w : inner_) {
        if (moves_.worst_around(w, good) < good) moves_.try_better_places(w, radius, {mesh_.positions[w]});
      }
      if (worst_of_chosen(v) >= wanted) return true;
    }
    for (std::size_t i = 0; i < inner_.size(); ++i)
      mesh_.positions[inner_[i]] = saved_[i];
    return false;
  }

  HexMesh& mesh_;
  const HexBoundary& boundary_;
  const SurfaceTarget& target_;
  const double distance_;
  const base::Host& host_;
  HexMoves moves_;
  double floor_ = 0;                         // of the quality of hexahedra
  const Array<mesh::Triangle> halves_;       // of quads
  const base::Groups<Index, Index> around_;  // of those
  Array<Vector3> samples_;
  Array<Index> inner_;  // around the vertex that is moved
  Array<Vector3> saved_;
};

}  // namespace

void reach_surface(HexMesh& mesh, const HexBoundary& boundary, const SurfaceTarget& target, double distance,
                   const base::Host& host) {
  Reach(mesh, boundary, target, distance, host).run();
}

}  // namespace orbicube::hexmesh
