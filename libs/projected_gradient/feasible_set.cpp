#include "projected_gradient/feasible_set.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/hash.h"
#include "projected_gradient/row_equation.h"
#include "projected_gradient/vector_math.h"

namespace orbicube::projected_gradient {
namespace {

// A residual of a row that is rounding, relative to the sizes of its terms.
constexpr double row_accuracy = 1e-15;
// A projection that leaves more has failed.
constexpr double acceptable = 1e-10;

base::Array<double> bounds_or(std::span<const double> given, std::size_t n, double otherwise,
                              std::pmr::memory_resource* memory) {
  if (given.empty()) return base::Array<double>(n, otherwise, memory);
  if (given.size() != n) throw base::Error("invalid-argument", "bounds must have one entry an unknown");
  return base::Array<double>(given.begin(), given.end(), memory);
}

}  // namespace

FeasibleSet::FeasibleSet(const Problem& problem, std::pmr::memory_resource* memory)
    : lower_(bounds_or(problem.lower, problem.n, -std::numeric_limits<double>::infinity(), memory)),
      upper_(bounds_or(problem.upper, problem.n, std::numeric_limits<double>::infinity(), memory)),
      rows_(problem, memory),
      custom_(problem.project),
      free_(problem.n, 0, memory),
      guess_(rows_.rows(), 0.0, memory),
      certificate_(rows_.rows(), 0.0, memory),
      multiplier_(rows_.rows(), 0.0, memory),
      newton_(rows_.rows(), 0.0, memory),
      residual_(rows_.rows(), 0.0, memory),
      moved_(rows_.rows() > 0 ? problem.n : 0, 0.0, memory),
      direction_(moved_.size(), 0.0, memory) {
  if (problem.n == 0) throw base::Error("invalid-argument", "there are no unknowns");
  if (custom_ && (rows_.rows() > 0 || !problem.lower.empty() || !problem.upper.empty())) {
    throw base::Error("invalid-argument", "give either a projection or bounds and rows");
  }
  for (std::size_t j = 0; j < size(); ++j) {
    if (!(lower_[j] <= upper_[j]) || lower_[j] > max_coordinate || upper_[j] < -max_coordinate) {
      throw base::Error("invalid-argument",
                        "no number, or none within 1e150, lies within the bounds of unknown " + std::to_string(j));
    }
  }
  if (rows() > 0) factor_.emplace(rows_, memory);
  if (rows() == 1) {
    // The row as a dense vector, as the equation along a line wants it.
    const auto columns = rows_.row_columns(0);
    for (std::size_t k = 0; k < columns.size(); ++k)
      direction_[columns[k]] = rows_.row_values(0)[k];
  }
}

void FeasibleSet::clip_into(std::span<const double> y, std::span<double> x) const {
  for (std::size_t j = 0; j < y.size(); ++j)
    x[j] = clip(y[j], lower_[j], upper_[j]);
}

Projected FeasibleSet::project(std::span<const double> y, std::span<double> x, double step, const base::Host& host) {
  host.report("projection", passes_, 0);
  if (custom_) {
    ++passes_;
    return custom_(y.data(), x.data()) && all_finite(x) ? Projected::done : Projected::failed;
  }
  if (rows() == 0) {
    ++passes_;
    clip_into(y, x);
    return Projected::done;
  }
  return rows() == 1 ? project_one_row(y, x, step) : project_many_rows(y, x, step, host);
}

Projected FeasibleSet::project_one_row(std::span<const double> y, std::span<double> x, double step) {
  const RowEquation equation{direction_, y, lower_, upper_, rows_.rhs()[0]};
  const RowRoot root = solve_row_equation(equation, guess_[0] * step, 0);
  passes_ += root.passes + 1;
  if (!root.feasible) {
    // With +-1 as multiplier: the row cannot be as large, or as small, as b.
    const double multiplier = root.residual < 0 ? 1 : -1;
    if (certify({&multiplier, 1})) return Projected::infeasible;
    // Else the row is met only at its extreme, and missed there by rounding.
  }
  if (step > 0) guess_[0] = root.t / step;
  for (std::size_t j = 0; j < x.size(); ++j)
    x[j] = clip(y[j] + root.t * direction_[j], lower_[j], upper_[j]);
  // Where y is far larger than x, t is not resolved well enough to meet the row; the free unknowns still can.
  if (rows_.residual(x, residual_) > row_accuracy) {
    choose_face(x);
    meet_rows(x);
    passes_ += 3;
    if (rows_.residual(x, residual_) > acceptable) return Projected::failed;
  }
  return Projected::done;
}

// Maximizes the concave dual function of t, whose gradient is b - A clip(y + A't): Newton steps with A_F A_F' + shift I
// for the second derivative (semismooth Newton; Li, Sun, Toh 2018 and Qi, Sun 1993), each followed by a search along
// the step, which is again one row equation. The shift keeps rows without free unknowns moving.
Projected FeasibleSet::project_many_rows(std::span<const double> y, std::span<double> x, double step,
                                         const base::Host& host) {
  constexpr int newton_limit = 500, without_gain_limit = 8;
  constexpr double longest_search = 1e4;
  constexpr int block = 12;
  // From here on, what is left may be the rounding of t and y; the free unknowns then meet the rows.
  const double resolved = std::max(1e-6, 1e-14 * max_magnitude(y));
  const std::size_t m = rows(), n = size();
  for (std::size_t i = 0; i < m; ++i)
    multiplier_[i] = guess_[i] * step;
  double best = std::numeric_limits<double>::infinity();
  int without_gain = 0;
  for (int iteration = 0; iteration < newton_limit && without_gain < without_gain_limit; ++iteration) {
    host.report("projection", passes_, 0);
    for (std::size_t j = 0; j < n; ++j) {
      moved_[j] = y[j] + rows_.column_times(j, multiplier_);
      x[j] = clip(moved_[j], lower_[j], upper_[j]);
    }
    const double worst = rows_.residual(x, residual_);
    ++passes_;
    // Taking out what is left against infinite bounds costs a factor of its own: not at every step.
    const bool thorough = iteration % 10 == 9;
    if (worst > 0.5 * best && (thorough ? certify(residual_) : proves_infeasible(residual_))) {
      return Projected::infeasible;
    }
    if (worst < best) {
      without_gain = 0;
      best = worst;
    } else if (best <= resolved) {
      ++without_gain;
    }
    if (worst <= row_accuracy) break;

    const double residual_size = max_magnitude(residual_);
    mark_free(x);
    const double shift = std::clamp(0.1 * residual_size, 1e-13, 1e-3);
    factor_face(shift);
    std::copy(residual_.begin(), residual_.end(), newton_.begin());
    factor_->solve(newton_);
    const double slope = dot(newton_, residual_);
    if (!(slope > 0)) break;
    for (std::size_t j = 0; j < n; ++j)
      direction_[j] = rows_.column_times(j, newton_);
    const RowEquation along{direction_, moved_, lower_, upper_, dot(newton_, rows_.rhs())};
    const RowRoot root = solve_row_equation(along, 1, 0.1 * slope);
    passes_ += root.passes + 1;
    // Steps that are far longer than y and t would leave nothing but rounding of x.
    const double reach = longest_search * (1 + max_magnitude(y) + max_magnitude(multiplier_));
    const bool bounded = root.feasible && std::abs(root.t) * max_magnitude(newton_) < reach;
    if (!bounded && certify(newton_)) return Projected::infeasible;
    // Searches to the end cross the flat pieces of the function of t; full steps, between them and for whole blocks,
    // bring the residual to the minimum that the bounds allow, which proves infeasible rows (along those the function
    // rises for ever).
    const bool to_the_end = bounded && (root.t < 1 || (iteration % 3 == 0 && iteration / block % 2 == 0));
    const double length = to_the_end ? root.t : 1;
    for (std::size_t i = 0; i < m; ++i)
      multiplier_[i] += length * newton_[i];
  }
  return meet_many_rows(x, step, !(best > resolved));
}

// The free unknowns meet the rows; says what became of the projection, `converged` or not, and keeps its multipliers.
Projected FeasibleSet::meet_many_rows(std::span<double> x, double step, bool converged) {
  choose_face(x);
  meet_rows(x);
  passes_ += 3;
  if (!converged || rows_.residual(x, residual_) > acceptable)
    return certify(residual_) ? Projected::infeasible : Projected::failed;
  if (step > 0) {
    for (std::size_t i = 0; i < rows(); ++i)
      guess_[i] = multiplier_[i] / step;
  }
  return Projected::done;
}

// Farkas: the largest value that lambda'A x takes within the bounds stays below lambda'b. With an infinite bound that
// value is finite only where (A'lambda)_j is zero, which rounding never gives exactly: parts of 1e-9 count as zero.
bool FeasibleSet::proves_infeasible(std::span<const double> multipliers) {
  constexpr double zero = 1e-9, margin = 1e-9;
  const double length = std::sqrt(dot(multipliers, multipliers));
  if (!(length > 0) || !std::isfinite(length)) return false;
  double largest = 0, scale = 0;
  for (std::size_t j = 0; j < size(); ++j) {
    const double slope = rows_.column_times(j, multipliers) / length;
    if (slope == 0) continue;
    const double bound = slope > 0 ? upper_[j] : lower_[j];
    if (!std::isfinite(bound)) {
      if (std::abs(slope) > zero) return false;
      continue;
    }
    largest += slope * bound;
    scale += std::abs(slope * bound);
  }
  const double target = dot(multipliers, rows_.rhs()) / length;
  const double gap = target - largest;
  for (std::size_t i = 0; i < rows(); ++i)
    scale += std::abs(multipliers[i] * rows_.rhs()[i]) / length;
  if (!(gap > margin * scale)) return false;
  certificate_gap_ = gap;
  for (std::size_t i = 0; i < rows(); ++i)
    certificate_[i] = multipliers[i] / length * rows_.scale(i);
  return true;
}

bool FeasibleSet::certify(std::span<const double> multipliers) {
  if (proves_infeasible(multipliers)) return true;
  // What is left of A'lambda against infinite bounds may only be small: take it out, and try again.
  std::fill(certificate_.begin(), certificate_.end(), 0.0);
  bool any = false;
  for (std::size_t j = 0; j < size(); ++j) {
    const double slope = rows_.column_times(j, multipliers);
    free_[j] = slope != 0 && !std::isfinite(slope > 0 ? upper_[j] : lower_[j]);
    if (!free_[j]) continue;
    any = true;
    const auto touched = rows_.column_rows(j);
    for (std::size_t k = 0; k < touched.size(); ++k)
      certificate_[touched[k]] += slope * rows_.column_values(j)[k];
  }
  if (!any) return false;
  factored_shift_ = not_factored;
  factor_face(0);
  factor_->solve(certificate_);
  for (std::size_t i = 0; i < rows(); ++i)
    certificate_[i] = multipliers[i] - certificate_[i];
  return proves_infeasible(certificate_);
}

void FeasibleSet::mark_free(std::span<const double> x) {
  free_count_ = 0;
  for (std::size_t j = 0; j < x.size(); ++j) {
    const std::uint8_t inside = x[j] > lower_[j] && x[j] < upper_[j];
    if (inside != free_[j]) factored_shift_ = not_factored;
    free_[j] = inside;
    free_count_ += inside;
  }
}

void FeasibleSet::factor_face(double shift) {
  if (rows() == 0 || factored_shift_ == shift) return;
  factor_->factor(rows_, free_, shift);
  factored_shift_ = shift;
}

void FeasibleSet::choose_face(std::span<const double> x) {
  if (custom_) return;
  mark_free(x);
  factor_face(0);
}

void FeasibleSet::subtract_rows(std::span<const double> t, std::span<double> v) const {
  for (std::size_t j = 0; j < v.size() && rows() > 0; ++j)
    v[j] -= rows_.column_times(j, t);
}

void FeasibleSet::project_to_face(std::span<double> v) const {
  for (std::size_t j = 0; j < v.size(); ++j) {
    if (!free_[j]) v[j] = 0;
  }
  if (rows() == 0) return;
  // Twice, so that A v is rounding also where the rows are ill-conditioned.
  for (int repeat = 0; repeat < 2; ++repeat) {
    rows_.multiply_free(v, free_, residual_);
    factor_->solve(residual_);
    for (std::size_t j = 0; j < v.size(); ++j) {
      if (free_[j]) v[j] -= rows_.column_times(j, residual_);
    }
  }
}

void FeasibleSet::meet_rows(std::span<double> x) const {
  if (rows() == 0 || custom_) return;
  for (int repeat = 0; repeat < 3; ++repeat) {
    if (rows_.residual(x, residual_) <= row_accuracy) return;
    factor_->solve(residual_);
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (free_[j]) x[j] = clip(x[j] + rows_.column_times(j, residual_), lower_[j], upper_[j]);
    }
  }
}

std::uint64_t FeasibleSet::fingerprint() const {
  base::Hash hash;
  const auto add = [&](auto array) { hash.add(std::as_bytes(array)); };
  add(std::span(lower_));
  add(std::span(upper_));
  add(rows_.rhs());
  for (std::size_t i = 0; i < rows(); ++i) {
    const double scale = rows_.scale(i);
    add(std::span(&scale, 1));
    add(rows_.row_columns(i));
    add(rows_.row_values(i));
  }
  return hash.value() ^ static_cast<std::uint64_t>(custom());
}

}  // namespace orbicube::projected_gradient
