#include "volume_map/hex_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace orbicube::volume_map {
namespace {

constexpr double lowest = -20, lowest_coefficients = -5;
constexpr double floor_of_snapping = 0.15;

class Search {
 public:
  Search(HexMesh& mesh, const HexBoundary& boundary, const HexSearchOptions& options, const base::Host& host)
      : mesh_(mesh),
        boundary_(boundary),
        options_(options),
        host_(host),
        begin_(mesh.positions.size() + 1, 0, host.memory),
        around_(8 * mesh.hexahedra.size(), host.memory) {
    for (const Hexahedron& h : mesh.hexahedra) {
      for (const Index v : h)
        ++begin_[v + 1];
    }
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      begin_[v + 1] += begin_[v];
    Array<Index> next(begin_, host.memory);
    for (Index i = 0; i < mesh.hexahedra.size(); ++i) {
      for (const Index v : mesh.hexahedra[i])
        around_[next[v]++] = i;
    }
  }

  // Vertices that are on the surface by as much as their hexahedra allow, which are to stay as good as `floor`. Answers
  // how many are not there.
  std::size_t snap(double floor) {
    std::size_t left = 0, count = 0;
    for (const Index v : boundary_.vertices()) {
      if (count++ % 64 == 0) host_.report("snap", count, boundary_.vertices().size());
      Vector3& x = mesh_.positions[v];
      const Vector3 from = x;
      const Vector3 to = boundary_.project(v, from).position;
      if (from == to) continue;
      const double before = std::min(worst_around(v, lowest), floor);
      bool done = false;
      for (const double part : {1.0, 0.5, 0.25}) {
        x = part == 1 ? to : Vector3(from + part * (to - from));
        if (worst_around(v, before) >= before) {
          done = part == 1;
          break;
        }
        x = from;
      }
      left += !done;
    }
    return left;
  }

  // What the search has won is not to be lost: places on a lifted surface move a little each time.
  std::size_t snap_without_loss() {
    const double won = std::max(floor_of_snapping, worst());
    snap(won);
    return snap(won);
  }

  double worst() const {
    double result = 1;
    for (Index i = 0; i < mesh_.hexahedra.size(); ++i)
      result = std::min(result, quality(i, result));
    return result;
  }

  // The worst hexahedra, by moves of their vertices that make the worst around each better.
  void improve() {
    Array<std::pair<double, Index>> order(mesh_.hexahedra.size(), host_.memory);
    // Of all hexahedra, as of the last pass; few change in each.
    Array<double> qualities(order.size(), 0, host_.memory);
    Array<std::uint8_t> changed(order.size(), 1, host_.memory);
    Array<Index> vertices(host_.memory);
    const auto most = std::min(
        order.size(),
        std::max<std::size_t>(30, static_cast<std::size_t>(options_.part * static_cast<double>(order.size()))));
    double radius = 0.2;
    const Array<Vector3> start(mesh_.positions, host_.memory);
    for (int pass = 0; pass < options_.passes; ++pass, radius = std::max(0.01, 0.93 * radius)) {
      for (Index i = 0; i < order.size(); ++i) {
        if (i % 1024 == 0) report("improve", pass, options_.passes);
        if (changed[i] != 0) qualities[i] = quality(i, lowest);
        changed[i] = 0;
        order[i] = {qualities[i], i};
      }
      std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most), order.end());
      vertices.clear();
      for (std::size_t i = 0; i < most; ++i) {
        for (const Index v : mesh_.hexahedra[order[i].second])
          vertices.push_back(v);
      }
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      for (const Index v : vertices) {
        report("improve", pass, options_.passes);
        const double before = worst_around(v, lowest);
        double worst = before;
        try_places(v, radius, {start[v], held(v) ? options_.reach : infinity}, [&] {
          const double now = worst_around(v, worst);
          const bool better = now > worst + least_gain;
          if (better) worst = now;
          return better;
        });
        for (Index i = begin_[v]; worst > before && i < begin_[v + 1]; ++i)
          changed[around_[i]] = 1;
      }
    }
  }

  // All hexahedra on average, by moves after which the sum of the scaled Jacobians around a vertex is greater. The
  // worst around it may become less good as long as it stays good, and better than the worst of the mesh.
  void raise_mean() {
    constexpr double nothing_to_gain = 0.985;
    const double kept = std::max(options_.kept, worst());
    const Array<Vector3> start(mesh_.positions, host_.memory);
    double radius = 0.2;
    for (int pass = 0; pass < options_.mean_passes; ++pass, radius *= 0.85) {
      for (Index v = 0; v < mesh_.positions.size(); ++v) {
        if (v % 64 == 0) report("raise", pass, options_.mean_passes);
        double sum = sum_around(v);
        if (sum > nothing_to_gain * (begin_[v + 1] - begin_[v])) continue;
        const double floor = std::min(kept, worst_around(v, lowest));
        const double reach = held(v) ? std::min(options_.reach, options_.mean_reach) : options_.mean_reach;
        try_places(v, radius, {start[v], reach}, [&] {
          const double now = sum_around(v);
          const bool better = now > sum + least_gain && worst_around(v, floor) >= floor;
          if (better) sum = now;
          return better;
        });
      }
    }
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double least_gain = 1e-6;

  // Where a vertex of the boundary may be tried.
  struct Range {
    Vector3 center;
    double reach;
  };

  void report(const char* phase, int pass, int passes) const {
    host_.report(phase, static_cast<std::uint64_t>(pass), static_cast<std::uint64_t>(passes));
  }

  bool held(Index v) const { return options_.all || boundary_.hold(v) > 1; }

  // From -1 to 1.
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-52 - 1; }

  // Places for a vertex within so many times its shortest edge; of those on the boundary on the surface and in the
  // range. It stays where `accept` answers true.
  template <class Accept>
  void try_places(Index v, double radius, const Range& range, const Accept& accept) {
    constexpr int far_trials = 4, near_trials = 4;
    constexpr double near = 0.2;  // of the radius
    Vector3& x = mesh_.positions[v];
    const double edge = shortest_edge(v);
    for (int trial = 0; trial < far_trials + near_trials; ++trial) {
      const Vector3 from = x;
      const double reach = radius * edge * (trial < far_trials ? 1 : near);
      // In this order: arguments of a call have none.
      const double a = uniform(), b = uniform(), c = uniform();
      x = from + reach * Vector3(a, b, c);
      bool allowed = true;
      if (boundary_.kind(v) != HexBoundary::Kind::inside) {
        x = boundary_.project(v, x).position;
        allowed = (x - range.center).norm() <= range.reach;
      }
      if (!allowed || !accept()) x = from;
    }
  }

  // An inverted corner is worse than any coefficient.
  double corners(Index hexahedron) const {
    const double least = scaled_jacobian(mesh_.positions, mesh_.hexahedra[hexahedron]);
    return least > 0 ? least : least - 10;
  }
  // Coefficients are below the corners' in good hexahedra too; they are to be positive, no more.
  double coefficients(Index hexahedron) const {
    return std::max(lowest_coefficients, 6 * least_bezier(mesh_.positions, mesh_.hexahedra[hexahedron]));
  }
  // Not computed to the end where it is below `enough`.
  double quality(Index hexahedron, double enough) const {
    const double result = corners(hexahedron);
    return result < std::max(enough, lowest_coefficients) ? result : std::min(result, coefficients(hexahedron));
  }
  double worst_around(Index v, double enough) const {
    // Corners of all first: they take less time and tell most often.
    double worst = 1;
    for (Index i = begin_[v]; i < begin_[v + 1]; ++i) {
      worst = std::min(worst, corners(around_[i]));
      if (worst < enough) return worst;
    }
    if (worst < lowest_coefficients) return worst;
    for (Index i = begin_[v]; i < begin_[v + 1]; ++i) {
      worst = std::min(worst, coefficients(around_[i]));
      if (worst < enough) return worst;
    }
    return worst;
  }
  double sum_around(Index v) const {
    double sum = 0;
    for (Index i = begin_[v]; i < begin_[v + 1]; ++i)
      sum += scaled_jacobian(mesh_.positions, mesh_.hexahedra[around_[i]]);
    return sum;
  }
  double shortest_edge(Index v) const {
    double least = infinity;
    for (Index i = begin_[v]; i < begin_[v + 1]; ++i) {
      const Hexahedron& h = mesh_.hexahedra[around_[i]];
      for (std::size_t k = 0; k < 8; ++k) {
        if (h[k] != v) continue;
        for (const std::uint8_t n : corner_neighbours[k])
          least = std::min(least, (mesh_.positions[h[n]] - mesh_.positions[v]).norm());
      }
    }
    return least;
  }

  HexMesh& mesh_;
  const HexBoundary& boundary_;
  const HexSearchOptions& options_;
  const base::Host& host_;
  Array<Index> begin_, around_;  // hexahedra around each vertex
  std::mt19937_64 random_{1};
};

}  // namespace

std::size_t search_hexahedra(HexMesh& mesh, const HexBoundary& boundary, const HexSearchOptions& options,
                             const base::Host& host) {
  Search search(mesh, boundary, options, host);
  for (int k = 0; k < 3; ++k)
    search.snap(floor_of_snapping);
  search.improve();
  return search.snap_without_loss();
}

std::size_t raise_mean(HexMesh& mesh, const HexBoundary& boundary, const HexSearchOptions& options,
                       const base::Host& host) {
  Search search(mesh, boundary, options, host);
  search.raise_mean();
  return search.snap_without_loss();
}

}  // namespace orbicube::volume_map
