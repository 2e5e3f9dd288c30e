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
//   bool minimizer(block, x) const                         x becomes the best place in closed form; true if there is
//   one double longest_angle(block, direction) const           how far along the unit tangent the energy may be
//   evaluated bool valid(block, x) const                             whether x may be taken at all
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
concept HasMinimiser = requires(const Energy& energy, double* out) {
  energy.minimiser(0, out);
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

// Moves `block` from x (d numbers of the caller's, which the energy sees) to a better place if there is one. `reach` is
// the block's own memory from step to step: the inverse of the curvature that it met along its arc, 0 at first.
template <class Energy>
BlockStep improve_block(const Energy& energy, std::size_t block, const StepRule& rule, double* x, double& reach) {
  const auto d = energy.dimension();
  using Dimension = detail::DimensionOf<Energy>;
  constexpr double decrease = 1e-4, quarter_circle = 0.5 * std::numbers::pi;
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  constexpr int trial_limit = 40;
  BlockVector<Dimension> whole{}, gradient, direction{}, candidate, velocity;
  BlockStep step;
  double value;
  bool newton = false;
  step.evaluations = 1;
  if constexpr (detail::HasHessian<Energy>) {
    BlockMatrix<Dimension> hessian;
    value = energy.value_gradient_and_hessian(block, whole.data(), hessian.data());
    gradient = whole;
    make_tangent(d, x, gradient.data());
    newton = !rule.as_printed && std::isfinite(value) && detail::block_finite(d, whole.data()) &&
             detail::newton_direction(d, x, whole.data(), gradient.data(), hessian.data(), direction.data());
  } else {
    value = energy.value_and_gradient(block, whole.data());
    gradient = whole;
    make_tangent(d, x, gradient.data());
  }
  step.failed = !std::isfinite(value) || !detail::block_finite(d, whole.data());
  if (step.failed) return step;
  step.gradient_norm = std::sqrt(block_dot(d, gradient.data(), gradient.data()));
  if (step.gradient_norm <= rule.gradient_tolerance) return step;

  const auto allowed = [&] {
    if constexpr (detail::HasValid<Energy>) return energy.valid(block, candidate.data());
    return true;
  };
  double best_value = value, best_angle = 0;
  BlockVector<Dimension> best;
  std::copy_n(x, std::size_t{d}, best.begin());
  const auto try_at = [&](double angle) {
    move(d, x, direction.data(), angle, candidate.data(), velocity.data());
    if (!allowed()) return std::numeric_limits<double>::quiet_NaN();
    ++step.evaluations;
    const double new_value = energy.value(block, candidate.data());
    if (!std::isfinite(new_value)) return std::numeric_limits<double>::quiet_NaN();
    if (new_value < best_value) {
      best_value = new_value;
      best_angle = angle;
      best = candidate;
    }
    return new_value;
  };
  const auto take_best = [&] {
    std::copy_n(best.begin(), std::size_t{d}, x);
    step.gain = value - best_value;
    step.angle = best_angle;
    return step;
  };

  double target_angle = 0;  // where the curvature along `direction` is known
  if constexpr (detail::HasMinimiser<Energy>) {
    if (!rule.as_printed && energy.minimiser(block, candidate.data()) && normalize(d, candidate.data())) {
      const double cosine = block_dot(d, x, candidate.data());
      direction = candidate;
      make_tangent(d, x, direction.data());
      target_angle = std::atan2(std::sqrt(block_dot(d, direction.data(), direction.data())), cosine);
    }
  }
  double length = std::sqrt(block_dot(d, direction.data(), direction.data()));
  if (newton && target_angle == 0) target_angle = std::min(length, quarter_circle);
  if (!(length > 0 && block_dot(d, gradient.data(), direction.data()) < 0)) {
    direction = gradient;
    length = -step.gradient_norm;
    target_angle = reach * step.gradient_norm;
  }
  for (std::size_t k = 0; k < d; ++k)
    direction[k] /= length;
  double longest = std::max(quarter_circle, target_angle);
  if constexpr (detail::HasLongestAngle<Energy>)
    longest = std::min(longest, energy.longest_angle(block, direction.data()));
  const double slope = block_dot(d, gradient.data(), direction.data());

  if (rule.as_printed) {
    double angle = std::min(printed_angle(d, x, whole.data()), longest);
    for (int trial = 0; trial < trial_limit; ++trial, angle *= 0.5) {
      const double new_value = try_at(angle);
      double chord = 0;
      for (std::size_t k = 0; k < d; ++k)
        chord += (candidate[k] - x[k]) * whole[k];
      if (new_value <= value + decrease * chord && new_value < value) return take_best();
    }
    return step;
  }

  double angle = target_angle > 0 ? std::min(rule.over_relaxation * target_angle, longest) : 0.25 * longest;
  for (int trial = 0; trial < trial_limit; ++trial) {
    const double new_value = try_at(angle);
    // The parabola through the value and slope here and the value there.
    const double bend = 2 * (new_value - value - angle * slope) / (angle * angle);
    const double vertex = bend > 0 ? std::min(-slope / bend, longest) : longest;
    if (new_value <= value + decrease * angle * slope) {
      if (std::abs(new_value - value) > rounding * std::abs(value)) {
        // Where nothing was known, the first trial may be far from where the parabola is least.
        const bool near = angle > 0.5 * vertex && angle < 2 * vertex;
        if (target_angle == 0 && !near) try_at(std::min(rule.over_relaxation * vertex, longest));
        reach = vertex / step.gradient_norm;
      }
      return take_best();
    }
    angle = std::clamp(vertex, 0.1 * angle, 0.5 * angle);
  }
  return take_best();
}

}  // namespace orbicube::sphere_optimizer
