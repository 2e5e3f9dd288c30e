#include <algorithm>
#include <limits>
#include <random>

#include "base/grouping.h"
#include "base/random.h"
#include "hexmesh/features/feature_fitting.h"
#include "hexmesh/features/unfolding.h"

namespace orbicube::hexmesh {
namespace {

// Hexahedra below are searched: those below the best that the features allow everywhere, or else the worst ones.
constexpr double good = 0.6, below_bound = 0.02;
constexpr std::size_t max_worst = 1000;  // of a pass
constexpr int max_passes = 60, idle_passes = 6;
constexpr double first_radius = 0.25, last_radius = 0.02, shrinking = 0.96;  // times the shortest edge

class FeatureSearch {
 public:
  FeatureSearch(HexMesh& mesh, FeatureTargets& targets, double bound, const base::Host& host)
      : mesh_(mesh),
        targets_(targets),
        host_(host),
        bound_(bound),
        around_(base::cells_around(std::span<const Hexahedron>(mesh.hexahedra), mesh.positions.size(), host.memory)) {}

  // Lets vertices of patches leave sharp lines where hexahedra are worse than they may be on patches.
  void release_places() {
    for (const Index v : targets_.vertices()) {
      if (targets_.kind(v) == FeatureTargets::Kind::patch && targets_.is_kept(v) && worst_around(v) < patch_floor())
        targets_.release(v);
    }
  }

  // Returns how many vertices are not on their targets.
  std::size_t snap() {
    constexpr int rounds = 4;
    // Of the worst hexahedron around a vertex. A mesh without a part of an arc has lost it; one that is a little off a
    // patch has not.
    constexpr double of_arcs = 0.06, positive = 1e-3;
    Array<double> before(mesh_.positions.size(), 1, host_.memory);  // once: each round would lower it
    for (const Index v : targets_.vertices())
      before[v] = worst_around(v);
    std::size_t left = 0;
    for (int round = 0; round < rounds; ++round) {
      left = 0;
      targets_.look_from(mesh_.positions);
      for (const Index v : targets_.vertices()) {
        if (v % 64 == 0) host_.report("snap", 0, 0);
        const Vector3 from = mesh_.positions[v], to = targets_.target(v, from).position;
        if (from == to) continue;
        const double floor = targets_.kind(v) == FeatureTargets::Kind::patch ? patch_floor() : of_arcs;
        const double least = std::max(positive, std::min(kept * before[v], floor));
        bool done = false;
        for (const double part : {1.0, 0.5, 0.25}) {
          mesh_.positions[v] = part == 1 ? to : Vector3(from + part * (to - from));
          if (worst_around(v) >= least) {
            done = part == 1;
            break;
          }
          mesh_.positions[v] = from;
        }
        left += done ? 0 : 1;
      }
      if (left == 0) break;
    }
    return left;
  }

  // Moves the vertices of hexahedra that may be folded off their targets.
  void free_folded() {
    constexpr int passes = 20;
    double radius = first_radius;
    for (int pass = 0; pass < passes; ++pass) {
      const Array<Index> vertices = vertices_of_worst(0, true);
      if (vertices.empty()) break;
      for (const Index v : vertices) {
        host_.report("search", static_cast<std::uint64_t>(pass), passes);
        try_positions(v, radius, true);
      }
      radius = std::max(last_radius, radius * shrinking);
    }
  }

  void improve() {
    constexpr double progress = 0.01;  // of what is missing
    double radius = first_radius, last = missing_quality();
    int idle = 0;
    for (int pass = 0; pass < max_passes && idle < idle_passes && last > 0; ++pass) {
      const Array<Index> vertices = vertices_of_worst(std::max(good, bound_ - below_bound), false);
      if (vertices.empty()) return;
      for (const Index v : vertices) {
        host_.report("search", static_cast<std::uint64_t>(pass), max_passes);
        try_positions(v, radius, false);
      }
      const double now = missing_quality();
      idle = now < last * (1 - progress) ? 0 : idle + 1;
      last = std::min(last, now);
      radius = std::max(last_radius, radius * shrinking);
    }
  }

 private:
  static constexpr double kept = 0.8;  // of what the worst hexahedron was, or of its bound

  double quality(Index hexahedron) const { return searched_quality(mesh_.positions, mesh_.hexahedra[hexahedron]); }
  double worst_around(Index v) const { return worst_searched_quality(mesh_, around_[v]); }
  double sum_around(Index v) const {
    double sum = 0;
    for (const Index h : around_[v])
      sum += scaled_jacobian(mesh_.positions, mesh_.hexahedra[h]);
    return sum;
  }
  double patch_floor() const {
    constexpr double of_patches = 0.2;
    return std::min(of_patches, kept * bound_);
  }
  double enough() const { return std::min(good, bound_ - below_bound); }
  // What a hexahedron is below that. The fourth power: the worst count most, but none becomes bad for another.
  double missing_quality(Index hexahedron) const {
    const double missing = std::max(0.0, enough() - quality(hexahedron)), square = missing * missing;
    return square * square;
  }
  double missing_quality() const {
    double sum = 0;
    for (Index i = 0; i < mesh_.hexahedra.size(); ++i)
      sum += missing_quality(i);
    return sum;
  }
  double missing_around(Index v) const {
    double sum = 0;
    for (const Index h : around_[v])
      sum += missing_quality(h);
    return sum;
  }

  // Of hexahedra of at most this quality.
  Array<Index> vertices_of_worst(double most, bool corners) const {
    Array<std::pair<double, Index>> worst(host_.memory);
    for (Index i = 0; i < mesh_.hexahedra.size(); ++i) {
      if (const double q = quality(i); q <= most) worst.push_back({q, i});
    }
    Array<Index> vertices = hexmesh::vertices_of_worst(mesh_.hexahedra, std::move(worst), max_worst);
    if (!corners) std::erase_if(vertices, [&](Index v) { return targets_.kind(v) == FeatureTargets::Kind::corner; });
    return vertices;
  }

  double shortest_edge(Index v) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Index i : around_[v]) {
      for (const Index w : mesh_.hexahedra[i]) {
        if (w != v) least = std::min(least, (mesh_.positions[w] - mesh_.positions[v]).norm());
      }
    }
    return least;
  }

  double uniform() { return 2 * base::unit_interval(random_()) - 1; }

  // Takes better positions; on the target of the vertex, unless it is free.
  void try_positions(Index v, double radius, bool free) {
    constexpr int trials = 8, far_trials = 4;
    constexpr double near = 0.2;       // of the radius
    constexpr double gain = 1e-3;      // of what is missing
    constexpr double on_patch = 0.02;  // cells
    double missing = missing_around(v), sum = sum_around(v);
    const double edge = shortest_edge(v);
    for (int trial = 0; trial < trials; ++trial) {
      const Vector3 from = mesh_.positions[v];
      const double place = targets_.place(v), reach = radius * edge * (trial < far_trials ? 1 : near);
      const double x = uniform(), y = uniform(), z = uniform();
      Vector3 to = from + reach * Vector3(x, y, z);
      if (!free && targets_.kind(v) == FeatureTargets::Kind::arc) {
        targets_.set_place(v, targets_.clamped_place(v, place + reach * x));
        to = targets_.shape().point(targets_.arc(v), targets_.place(v));
      } else if (!free && targets_.kind(v) == FeatureTargets::Kind::patch &&
                 (targets_.target(v, from).position - from).norm() < on_patch) {
        to = targets_.target(v, to).position;
      }
      mesh_.positions[v] = to;
      const double now = missing_around(v);
      const bool better = now < (1 - gain) * missing || (now <= missing && missing == 0 && sum_around(v) > sum);
      if (better) {
        missing = now;
        sum = sum_around(v);
      } else {
        mesh_.positions[v] = from;
        targets_.set_place(v, place);
      }
    }
  }

  HexMesh& mesh_;
  FeatureTargets& targets_;
  const base::Host& host_;
  const double bound_;
  base::Groups<Index, Index> around_;
  std::mt19937_64 random_{1};
};

}  // namespace

std::size_t snap_to_features(HexMesh& mesh, const BoxSizes& sizes, FeatureTargets& targets, double bound,
                             const base::Host& host) {
  constexpr int steps = 10;
  FeatureSearch search(mesh, targets, bound, host);
  search.release_places();
  search.snap();
  smooth_inside(mesh, sizes, targets, steps, host);
  const std::size_t left = search.snap();
  search.improve();
  return left == 0 ? 0 : search.snap();
}

std::size_t free_folded_hexahedra(HexMesh& mesh, const BoxSizes& sizes, FeatureTargets& targets, double bound,
                                  const base::Host& host) {
  const bool unfolded = unfold_hexahedra(mesh, sizes, targets, host);
  FeatureSearch search(mesh, targets, bound, host);
  if (!unfolded) search.free_folded();
  return search.snap();
}

}  // namespace orbicube::hexmesh
