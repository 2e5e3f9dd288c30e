// One step of one block while the others stay: the inner code of sphere maps (d = 3) and frame fields (d = 4), compiled
// for each energy, without a virtual call or an allocation.
//
// The energy of a block is a class with
//   Dimension dimension() const          FixedDimension<d>, or a std::size_t of at most max_block_dimension
//   double value(block, x) const                           its terms that contain `block`, if that was at x (d numbers)
//   double value_and_gradient(block, gradient) const       the same where it is, and its gradient in R^d
//   void for_each_neighbor(block, visit) const            visit(other) for each block whose terms contain this one
// and may have
//   double value_gradient_and_hessian(block, gradient, hessian) const  d x d: makes each step a Newton step
//   bool minimizer(block, x) const                x becomes the best place in closed form; true if there is one
//   double longest_angle(block, direction) const  how far along the unit tangent the energy may be evaluated
//   bool valid(block, x) const                    whether x may be taken at all
// Values and gradients that are not finite are taken for places where the block cannot be.
//
// The step is the dissertation's Algorithm 2 with its flaws mended: it goes along the tangent gradient (or Newton's
// direction, whose Hessian is that of the sphere, P (H - (g.x) I) P, made positive by a shift), as far as the curvature
// of the last step of the block, and shortens by the parabola through the values. Method::dissertation is Algorithm 2
// as printed.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>

#include "sphere_optimizer/great_circle.h"
#include "sphere_optimizer/spheres.h"

namespace orbicube::sphere_optimizer {

inline constexpr std::size_t max_block_dimension = 64;

template <class Dimension>
struct BlockCapacity : std::integral_constant<std::size_t, max_block_dimension> {};
template <std::size_t d>
struct BlockCapacity<FixedDimension<d>> : std::integral_constant<std::size_t, d> {};

// d numbers in registers or on the stack.
template <class Dimension>
using BlockVector = std::array<double, BlockCapacity<Dimension>::value>;
template <class Dimension>
using BlockMatrix = std::array<double, BlockCapacity<Dimension>::value * BlockCapacity<Dimension>::value>;

struct BlockStep {
  double gain = 0;           // by how much the energy fell; 0 when the block stays
  double angle = 0;          // by how much the block turned
  double gradient_norm = 0;  // of the tangent gradient before the step
  std::uint32_t evaluations = 0;
  bool failed = false;  // no value where the block is
};

namespace detail {

template <class Energy>
concept HasHessian = requires(const Energy& energy, double* out) {
  energy.value_gradient_and_hessian(0, out, out);
};
template <class Energy>
concept HasMinimizer = requires(const Energy& energy, double* out) {
  energy.minimizer(0, out);
};
template <class Energy>
concept HasLongestAngle = requires(const Energy& energy, const double* v) {
  energy.longest_angle(0, v);
};
template <class Energy>
concept HasValid = requires(const Energy& energy, const double* v) {
  energy.valid(0, v);
};

template <class Energy>
using DimensionOf = decltype(std::declval<const Energy&>().dimension());

template <class Dimension>
bool block_finite(Dimension d, const double* v) {
  double sum = 0;
  for (std::size_t k = 0; k < d; ++k)
    sum += 0.0 * v[k];
  return sum == 0;
}

// matrix = L L' in its lower triangle; false when it is not safely positive definite.
template <class Dimension>
bool factor(Dimension d, double* matrix, double smallest) {
  for (std::size_t j = 0; j < d; ++j) {
    for (std::size_t i = j; i < d; ++i) {
      double sum = matrix[i * d + j];
      for (std::size_t k = 0; k < j; ++k)
        sum -= matrix[i * d + k] * matrix[j * d + k];
      if (i == j) {
        if (!(sum > smallest)) return false;
        matrix[j * d + j] = std::sqrt(sum);
      } else {
        matrix[i * d + j] = sum / matrix[j * d + j];
      }
    }
  }
  return true;
}

// direction = -M^-1 gradient, M = P (H - (whole . x) I) P + shift I made safely positive definite. False when H is not
// finite.
template <class Dimension>
bool newton_direction(Dimension d, const double* x, const double* whole, const double* gradient, double* hessian,
                      double* direction) {
  const double radial = block_dot(d, whole, x);
  BlockVector<Dimension> column;
  // P H P, one side after the other.
  for (std::size_t i = 0; i < d; ++i)
    make_tangent(d, x, hessian + i * d);
  for (std::size_t j = 0; j < d; ++j) {
    for (std::size_t i = 0; i < d; ++i)
      column[i] = hessian[i * d + j];
    make_tangent(d, x, column.data());
    for (std::size_t i = 0; i < d; ++i)
      hessian[i * d + j] = column[i];
  }
  double size = 0;
  for (std::size_t i = 0; i < d; ++i) {
    double row = 0;
    for (std::size_t j = 0; j < d; ++j) {
      hessian[i * d + j] -= radial * ((i == j ? 1.0 : 0.0) - x[i] * x[j]);
      row += std::abs(hessian[i * d + j]);
    }
    if (!(row <= std::numeric_limits<double>::max())) return false;
    size = std::max(size, row);
  }
  if (!(size > 0)) return false;
  // Along x, which no tangent vector has a part in, anything positive will do.
  for (std::size_t i = 0; i < d; ++i) {
    for (std::size_t j = 0; j < d; ++j)
      hessian[i * d + j] += size * x[i] * x[j];
  }
  BlockMatrix<Dimension> factored;
  constexpr double safely = 1e-3;
  double shift = 0;
  for (;; shift = shift > 0 ? 4 * shift : 0.125 * size) {
    for (std::size_t i = 0; i < d * d; ++i)
      factored[i] = hessian[i];
    for (std::size_t i = 0; i < d; ++i)
      factored[i * d + i] += shift;
    if (factor(d, factored.data(), safely * size)) break;  // at the latest when the shift is beyond the rows' sums
  }
  for (std::size_t i = 0; i < d; ++i) {
    double sum = -gradient[i];
    for (std::size_t k = 0; k < i; ++k)
      sum -= factored[i * d + k] * direction[k];
    direction[i] = sum / factored[i * d + i];
  }
  for (std::size_t i = d; i-- > 0;) {
    double sum = direction[i];
    for (std::size_t k = i + 1; k < d; ++k)
      sum -= factored[k * d + i] * direction[k];
    direction[i] = sum / factored[i * d + i];
  }
  make_tangent(d, x, direction);
  return true;
}

}  // namespace detail

// How a block's step is made.
struct StepRule {
  double gradient_tolerance = 0;  // a block whose tangent gradient is at most this long stays
  double over_relaxation = 1;     // step length relative to the minimizer along the arc, from 1 to below 2
  bool as_printed = false;        // Algorithm 2 as printed
};

namespace detail {

// The search of one block along its great circle: first differentiate(), then choose_direction(), then the trials.
template <class Energy>
class ArcSearch {
 public:
  ArcSearch(const Energy& energy, std::size_t block, const StepRule& rule, double* x)
      : energy_(energy), block_(block), rule_(rule), d_(energy.dimension()), x_(x) {}

  const BlockStep& step() const { return step_; }

  // Value and gradients where the block is, and Newton's direction. Returns whether the block may move.
  bool differentiate() {
    step_.evaluations = 1;
    if constexpr (HasHessian<Energy>) {
      BlockMatrix<Dimension> hessian;
      value_ = energy_.value_gradient_and_hessian(block_, whole_.data(), hessian.data());
      gradient_ = whole_;
      make_tangent(d_, x_, gradient_.data());
      newton_ = !rule_.as_printed && std::isfinite(value_) && block_finite(d_, whole_.data()) &&
                newton_direction(d_, x_, whole_.data(), gradient_.data(), hessian.data(), direction_.data());
    } else {
      value_ = energy_.value_and_gradient(block_, whole_.data());
      gradient_ = whole_;
      make_tangent(d_, x_, gradient_.data());
    }
    step_.failed = !std::isfinite(value_) || !block_finite(d_, whole_.data());
    if (step_.failed) return false;
    step_.gradient_norm = std::sqrt(block_dot(d_, gradient_.data(), gradient_.data()));
    return !(step_.gradient_norm <= rule_.gradient_tolerance);
  }

  // The unit tangent of the search, its slope, the angle at which a minimum is expected, and the longest one.
  void choose_direction(double reach) {
    if constexpr (HasMinimizer<Energy>) {
      if (!rule_.as_printed && energy_.minimizer(block_, candidate_.data()) && normalize(d_, candidate_.data())) {
        const double cosine = block_dot(d_, x_, candidate_.data());
        direction_ = candidate_;
        make_tangent(d_, x_, direction_.data());
        target_angle_ = std::atan2(std::sqrt(block_dot(d_, direction_.data(), direction_.data())), cosine);
      }
    }
    double length = std::sqrt(block_dot(d_, direction_.data(), direction_.data()));
    if (newton_ && target_angle_ == 0) target_angle_ = std::min(length, quarter_circle);
    if (!(length > 0 && block_dot(d_, gradient_.data(), direction_.data()) < 0)) {
      direction_ = gradient_;
      length = -step_.gradient_norm;
      target_angle_ = reach * step_.gradient_norm;
    }
    for (std::size_t k = 0; k < d_; ++k)
      direction_[k] /= length;
    longest_ = std::max(quarter_circle, target_angle_);
    if constexpr (HasLongestAngle<Energy>)
      longest_ = std::min(longest_, energy_.longest_angle(block_, direction_.data()));
    slope_ = block_dot(d_, gradient_.data(), direction_.data());
    best_value_ = value_;
    std::copy_n(x_, std::size_t{d_}, best_.begin());
  }

  // Halves the angle until the decrease suffices; else the block stays.
  void search_as_printed() {
    double angle = std::min(printed_angle(d_, x_, whole_.data()), longest_);
    for (int trial = 0; trial < trial_limit; ++trial, angle *= 0.5) {
      const double new_value = try_at(angle);
      double chord = 0;
      for (std::size_t k = 0; k < d_; ++k)
        chord += (candidate_[k] - x_[k]) * whole_[k];
      if (new_value <= value_ + decrease * chord && new_value < value_) return take_best();
    }
  }

  // Shortens the angle by the parabola through the value and slope here and the value there.
  void search(double& reach) {
    double angle = target_angle_ > 0 ? std::min(rule_.over_relaxation * target_angle_, longest_) : 0.25 * longest_;
    for (int trial = 0; trial < trial_limit; ++trial) {
      const double new_value = try_at(angle);
      const double bend = 2 * (new_value - value_ - angle * slope_) / (angle * angle);
      const double vertex = bend > 0 ? std::min(-slope_ / bend, longest_) : longest_;
      if (new_value <= value_ + decrease * angle * slope_) {
        if (std::abs(new_value - value_) > rounding * std::abs(value_)) {
          // Where nothing was known, the first trial may be far from where the parabola is least.
          const bool near = angle > 0.5 * vertex && angle < 2 * vertex;
          if (target_angle_ == 0 && !near) try_at(std::min(rule_.over_relaxation * vertex, longest_));
          reach = vertex / step_.gradient_norm;
        }
        break;
      }
      angle = std::clamp(vertex, 0.1 * angle, 0.5 * angle);
    }
    take_best();
  }

 private:
  using Dimension = DimensionOf<Energy>;
  static constexpr double decrease = 1e-4, quarter_circle = 0.5 * std::numbers::pi;
  static constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  static constexpr int trial_limit = 40;

  bool allowed() const {
    if constexpr (HasValid<Energy>) return energy_.valid(block_, candidate_.data());
    return true;
  }

  // The value at an angle, which is remembered if it is the best one so far; not a number where the block cannot be.
  double try_at(double angle) {
    move(d_, x_, direction_.data(), angle, candidate_.data(), velocity_.data());
    if (!allowed()) return std::numeric_limits<double>::quiet_NaN();
    ++step_.evaluations;
    const double new_value = energy_.value(block_, candidate_.data());
    if (!std::isfinite(new_value)) return std::numeric_limits<double>::quiet_NaN();
    if (new_value < best_value_) {
      best_value_ = new_value;
      best_angle_ = angle;
      best_ = candidate_;
    }
    return new_value;
  }

  void take_best() {
    std::copy_n(best_.begin(), std::size_t{d_}, x_);
    step_.gain = value_ - best_value_;
    step_.angle = best_angle_;
  }

  const Energy& energy_;
  std::size_t block_;
  const StepRule& rule_;
  Dimension d_;
  double* x_;
  BlockStep step_;
  bool newton_ = false;                         // direction_ is Newton's
  double value_ = 0, slope_ = 0, longest_ = 0;  // where the block is, and along direction_
  double target_angle_ = 0;                     // where the curvature along direction_ is known
  double best_value_, best_angle_ = 0;          // of the trials
  BlockVector<Dimension> whole_{}, gradient_;   // the gradient in space, and its tangent part
  BlockVector<Dimension> direction_{}, best_;
  BlockVector<Dimension> candidate_, velocity_;  // of a trial
};

}  // namespace detail

// Moves `block` from x (d numbers of the caller's, which the energy sees) to a better place if there is one. `reach` is
// the block's own memory from step to step: the inverse of the curvature that it met along its arc, 0 at first.
template <class Energy>
BlockStep improve_block(const Energy& energy, std::size_t block, const StepRule& rule, double* x, double& reach) {
  detail::ArcSearch<Energy> search(energy, block, rule, x);
  if (!search.differentiate()) return search.step();
  search.choose_direction(reach);
  if (rule.as_printed)
    search.search_as_printed();
  else
    search.search(reach);
  return search.step();
}

}  // namespace orbicube::sphere_optimizer
