// Vertices of a mesh of hexahedra tried at other places: how good the hexahedra around each are, and places for it.
#pragma once

#include <algorithm>
#include <limits>
#include <random>

#include "base/grouping.h"
#include "base/random.h"
#include "hexmesh/quality/hex_boundary.h"

namespace orbicube::hexmesh {

class HexMoves {
 public:
  // Less than what any hexahedron has.
  static constexpr double lowest = -20;

  // Keeps references. About 8 bytes a vertex and 32 a hexahedron.
  HexMoves(HexMesh& mesh, const HexBoundary& boundary, const base::Host& host);

  std::span<const Index> around(Index vertex) const { return around_[vertex]; }

  // The scaled Jacobian, or what is less: six times the minimum Bernstein coefficient (those of good hexahedra are
  // below the corners', too; they are to be positive, no more), and for an inverted corner 10 less than its own. Not
  // computed to the end where it is below `enough`.
  double quality(Index hexahedron, double enough) const;
  double worst_around(Index vertex, double enough) const;
  double worst() const;  // of all
  // Of scaled Jacobians.
  double sum_around(Index vertex) const;

  // Where a vertex of the boundary may be tried.
  struct Range {
    Vector3 center;
    double reach = std::numeric_limits<double>::infinity();
  };

  // Random places for a vertex within the given multiple of its shortest edge; of those on the boundary where it may be
  // (hex_boundary.h) and in the range. It stays where `accept` returns true.
  template <class Accept>
  void try_places(Index vertex, double radius, const Range& range, const Accept& accept) {
    constexpr int far_trials = 4, near_trials = 4;
    constexpr double near = 0.2;  // of the radius
    Vector3& x = mesh_.positions[vertex];
    const double edge = min_edge_length(vertex);
    for (int trial = 0; trial < far_trials + near_trials; ++trial) {
      const Vector3 from = x;
      const double reach = radius * edge * (trial < far_trials ? 1 : near);
      x = from + reach * random_direction();
      bool allowed = true;
      if (boundary_.kind(vertex) != HexBoundary::Kind::inside) {
        x = boundary_.project(vertex, x).position;
        allowed = (x - range.center).norm() <= range.reach;
      }
      if (!allowed || !accept()) x = from;
    }
  }
  // Those that make the worst around the vertex better. Returns whether any did.
  bool try_better_places(Index vertex, double radius, const Range& range);

  // Anywhere in the cube from -1 to 1.
  Vector3 random_direction() {
    // In this order: arguments of a call have none.
    const double a = uniform(), b = uniform(), c = uniform();
    return {a, b, c};
  }

  static constexpr double min_gain = 1e-6;  // less is not taken

 private:
  double uniform() { return 2 * base::unit_interval(random_()) - 1; }
  double corners(Index hexahedron) const;
  double coefficients(Index hexahedron) const;
  double min_edge_length(Index vertex) const;

  HexMesh& mesh_;
  const HexBoundary& boundary_;
  base::Groups<Index, Index> around_;
  std::mt19937_64 random_{1};
};

}  // namespace orbicube::hexmesh
