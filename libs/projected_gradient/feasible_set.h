// The feasible set {A x = b, lower <= x <= upper} or a set of the user's: nearest points in it, its faces (the unknowns
// strictly between their bounds, with the rows restricted to them), and proof when it is empty.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory_resource>
#include <optional>
#include <span>

#include "base/array.h"
#include "base/host.h"
#include "projected_gradient/normal_factor.h"
#include "projected_gradient/problem.h"
#include "projected_gradient/sparse_rows.h"
#include "projected_gradient/vector_math.h"

namespace orbicube::projected_gradient {

enum class Projected : std::int32_t {
  done = 0,
  infeasible = 1,  // certificate() proves it
  failed = 2,      // the user's projection failed, or the rows could not be met
};

class FeasibleSet {
 public:
  // Copies the set. Throws invalid-argument for a bound that is NaN, lower > upper, or rows that SparseRows refuses.
  FeasibleSet(const Problem& problem, std::pmr::memory_resource* memory);

  std::size_t size() const { return lower_.size(); }
  std::size_t rows() const { return rows_.rows(); }
  bool custom() const { return static_cast<bool>(custom_); }
  // Whether there are bounds alone; and whether each unknown has both.
  bool box() const { return rows() == 0 && !custom(); }
  bool bounded() const { return all_finite(lower_) && all_finite(upper_); }
  std::span<const double> lower() const { return lower_; }
  std::span<const double> upper() const { return upper_; }

  // x = the point of the set nearest to y; x and y are different arrays. Every x_j is within its bounds to the bit.
  // `step` is how far along some direction y lies from a point of the set (0: unknown): the multipliers of the last
  // projection with a step, scaled by it, are the first guess.
  Projected project(std::span<const double> y, std::span<double> x, double step, const base::Host& host);

  // Fixes the face of x: unknowns strictly between their bounds are free.
  void choose_face(std::span<const double> x);
  std::span<const std::uint8_t> free() const { return free_; }
  std::size_t free_count() const { return free_count_; }
  const SparseRows& linear_rows() const { return rows_; }
  // x <- (A_F A_F')^-1 x for the free unknowns F of the face; m entries.
  void solve_normal(std::span<double> x) const { factor_->solve(x); }
  // v <- v - A't.
  void subtract_rows(std::span<const double> t, std::span<double> v) const;
  // v <- the nearest v with v_j = 0 on bounds and A v = 0.
  void project_to_face(std::span<double> v) const;

  // Largest relative residual of a row, |a'x - b| / (|b| + sum |a_j x_j|).
  double relative_residual(std::span<const double> x) const { return rows_.residual(x, residual_); }
  // Moves the free unknowns of the chosen face so that A x = b to rounding; bounds hold.
  void meet_rows(std::span<double> x) const;

  // After Projected::infeasible: lambda (m entries, for the rows as given) with lambda'A x < lambda'b for every x
  // within the bounds. certificate_gap() is lambda'b - max lambda'A x > 0 for lambda of length 1 (rows of length 1).
  std::span<const double> certificate() const { return certificate_; }
  double certificate_gap() const { return certificate_gap_; }

  std::uint64_t passes() const { return passes_; }

  // The multipliers of the last projection with a step, for one of length 1: P(y) = clip(y + A't).
  std::span<double> guess() { return guess_; }

  // A number that distinguishes problems: a hash of bounds and rows.
  std::uint64_t fingerprint() const;
  // Shows what a saved run must hold to `visit` as spans of numbers.
  template <class Self, class Visit>
  static void visit_state(Self& self, const Visit& visit) {
    visit(std::span(self.guess_));
    visit(std::span(self.certificate_));
    visit(std::span(&self.certificate_gap_, 1));
    visit(std::span(&self.passes_, 1));
  }

 private:
  Projected project_one_row(std::span<const double> y, std::span<double> x, double step);
  Projected project_many_rows(std::span<const double> y, std::span<double> x, double step, const base::Host& host);
  Projected meet_many_rows(std::span<double> x, double step, bool converged);
  bool certify(std::span<const double> multipliers);  // changes the marked face
  bool proves_infeasible(std::span<const double> multipliers);
  void mark_free(std::span<const double> x);
  void factor_face(double shift);
  void clip_into(std::span<const double> y, std::span<double> x) const;

  base::Array<double> lower_, upper_;
  SparseRows rows_;
  std::optional<NormalFactor> factor_;
  std::function<bool(const double*, double*)> custom_;
  base::Array<std::uint8_t> free_;
  std::size_t free_count_ = 0;
  static constexpr double not_factored = -1;
  double factored_shift_ = not_factored;  // the shift with which factor_ holds the factor of this face
  base::Array<double> guess_, certificate_, multiplier_, newton_;  // m each
  mutable base::Array<double> residual_;                           // m
  base::Array<double> moved_, direction_;  // n each where there are rows: y + A't, and A' of a direction of t
  double certificate_gap_ = 0;
  std::uint64_t passes_ = 0;
};

}  // namespace orbicube::projected_gradient
