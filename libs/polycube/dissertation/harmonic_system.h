// Harmonic functions with cotangent weights on a surface, with values fixed at some vertices: one factor for all
// patches, since fixed vertices separate them.
//
// Between two sets of fixed vertices few differ. Rows of vertices that become fixed are removed from the factor, those
// of vertices that become free put back by updates of rank one (Davis and Hager; the dissertation's section 4.4.1).
// Where many differ the matrix is factorized again, which then takes less time.
#pragma once

#include <memory>

#include "linear/direct/direct_factor.h"
#include "polycube/surface/editable_surface.h"

namespace orbicube::polycube::dissertation {

// Half the cotangent of the angle opposite to each half-edge: an edge's weight is the sum of its two (eq. 4.1).
Array<double> half_edge_weights(const EditableSurface& surface, const base::Host& host);

struct HarmonicCounts {
  std::uint64_t factorizations = 0, solves = 0;
  std::uint64_t rows_removed = 0, rows_added = 0;  // of factors that were kept
};

class HarmonicSystem {
 public:
  // More rows than this part of all are not worth an update.
  static constexpr double max_changed_part = 0.002;

  // The surface must outlive the system and not change.
  HarmonicSystem(const EditableSurface& surface, std::span<const double> weights, const base::Host& host);

  // Fixes the vertices with a flag, at least one. Returns whether the system can be solved. `may_update`: the factor
  // may be changed instead of made again.
  bool fix(std::span<const std::uint8_t> fixed, bool may_update = true);
  // Fills in the values of free vertices, from those of fixed ones. Returns false where they cannot be computed.
  bool solve(std::span<Vector3> values);

  const HarmonicCounts& counts() const { return counts_; }

 private:
  template <class Visit>
  void for_each_neighbor(Index v, const Visit& visit) const;
  bool factorize();
  void remove(Index v);
  bool add(Index v);
  double diagonal(Index v) const;
  double residual(std::span<const Vector3> values) const;

  const EditableSurface& surface_;
  std::span<const double> weights_;
  const base::Host& host_;
  linear::SparseMatrix matrix_;
  std::unique_ptr<linear::DirectFactor> factor_;
  Array<std::uint8_t> fixed_;
  bool updated_ = false;  // since the last factorization
  bool ready_ = false;
  Array<double> right_;
  HarmonicCounts counts_;
};

}  // namespace orbicube::polycube::dissertation
