#include "trust_region/quadratic_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trust_region/dense.h"

namespace orbicube::trust_region {
namespace {

// Relative, of |s| = radius, and of the model's reduction in the hard case.
constexpr double accuracy_of_length = 1e-9, accuracy_of_value = 1e-14;

}  // namespace

QuadraticStep::QuadraticStep(std::size_t n, std::pmr::memory_resource* memory)
    : n_(n),
      tridiagonal_(n, memory),
      gradient_(n, 0.0, memory),
      diagonal_(n, 0.0, memory),
      below_(n, 0.0, memory),
      inverse_pivot_(n, 0.0, memory),
      lower_(n, 0.0, memory),
      rotated_(n, 0.0, memory),
      trial_(n, 0.0, memory),
      derivative_(n, 0.0, memory),
      free_gradient_(n, 0.0, memory),
      free_step_(n, 0.0, memory),
      free_(n, 0, memory),
      fixed_(n, 0, memory) {}

void QuadraticStep::minimise(const double* gradient, const double* matrix, double radius, const double* lower,
                             const double* upper, double* s) {
  if (lower != nullptr) {
    minimise_in_box(1, gradient, matrix, radius, lower, upper, s);
    return;
  }
  std::copy_n(matrix, n_ * n_, tridiagonal_.matrix());
  reduce(n_, gradient);
  minimise_in_ball(1, n_, radius, s);
}

void QuadraticStep::minimise_and_maximise(const double* gradient, const double* matrix, double radius,
                                          const double* lower, const double* upper, double* lowest, double* highest) {
  minimise(gradient, matrix, radius, lower, upper, lowest);
  if (lower == nullptr) {
    minimise_in_ball(-1, n_, radius, highest);
  } else {
    minimise_in_box(-1, gradient, matrix, radius, lower, upper, highest);
  }
}

// The quadratic is multiplied by `sign`.
void QuadraticStep::minimise_in_box(double sign, const double* gradient, const double* matrix, double radius,
                                    const double* lower, const double* upper, double* s) {
  std::fill_n(s, n_, 0.0);
  for (std::size_t i = 0; i < n_; ++i) {
    fixed_[i] = (lower[i] >= 0 && sign * gradient[i] >= 0) || (upper[i] <= 0 && sign * gradient[i] <= 0) ? 1 : 0;
  }
  for (std::size_t round = 0; round <= n_; ++round) {
    std::size_t count = 0;
    double left = radius * radius;
    for (std::size_t i = 0; i < n_; ++i) {
      if (fixed_[i] != 0) {
        left -= s[i] * s[i];
      } else {
        free_[count++] = static_cast<std::uint32_t>(i);
      }
    }
    if (count == 0 || !(left > 0)) break;
    for (std::size_t a = 0; a < count; ++a) {
      const double* row = matrix + free_[a] * n_;
      double slope = gradient[free_[a]];
      for (std::size_t i = 0; i < n_; ++i) {
        if (fixed_[i] != 0) slope += row[i] * s[i];
      }
      free_gradient_[a] = slope;
      for (std::size_t b = 0; b < count; ++b)
        tridiagonal_.matrix()[a * count + b] = row[free_[b]];
    }
    reduce(count, free_gradient_.data());
    minimise_in_ball(sign, count, std::sqrt(left), free_step_.data());
    // Along the way there, up to the first bound.
    double part = 1;
    std::size_t hit = count;
    for (std::size_t a = 0; a < count; ++a) {
      const std::size_t i = free_[a];
      const double to = free_step_[a], bound = to > upper[i] ? upper[i] : to < lower[i] ? lower[i] : to;
      if (bound == to) continue;
      const double reach = (bound - s[i]) / (to - s[i]);
      if (reach < part || hit == count) {
        part = std::min(part, reach);
        hit = a;
      }
    }
    for (std::size_t a = 0; a < count; ++a)
      s[free_[a]] += part * (free_step_[a] - s[free_[a]]);
    if (hit == count) break;
    const std::size_t i = free_[hit];
    s[i] = free_step_[hit] > upper[i] ? upper[i] : lower[i];
    fixed_[i] = 1;
  }
  for (std::size_t i = 0; i < n_; ++i)
    s[i] = s[i] < lower[i] ? lower[i] : s[i] > upper[i] ? upper[i] : s[i];
}

// Pivots of T + shift I = LDL'; false unless it is positive definite.
bool QuadraticStep::factorise(std::size_t size, double shift) {
  double pivot = diagonal_[0] + shift;
  for (std::size_t i = 0;; ++i) {
    if (!(pivot > 0)) return false;
    inverse_pivot_[i] = 1 / pivot;
    if (i + 1 == size) return true;
    lower_[i] = below_[i] * inverse_pivot_[i];
    pivot = diagonal_[i + 1] + shift - below_[i] * lower_[i];
  }
}

// L x = right, then D L' x = that.
void QuadraticStep::solve(std::size_t size, const double* right, double* x) const {
  x[0] = right[0];
  for (std::size_t i = 1; i < size; ++i)
    x[i] = right[i] - lower_[i - 1] * x[i - 1];
  x[size - 1] *= inverse_pivot_[size - 1];
  for (std::size_t i = size - 1; i-- > 0;)
    x[i] = x[i] * inverse_pivot_[i] - lower_[i] * x[i + 1];
}

// A unit vector near the lowest eigenvalue's, by inverse iteration with the factors at hand; returns z'(T + shift I) z.
double QuadraticStep::lowest_direction(std::size_t size, double* z) {
  for (std::size_t i = 0; i < size; ++i)
    z[i] = i % 2 == 0 ? 1 : -0.5;
  double curvature = std::numeric_limits<double>::infinity();
  for (int round = 0; round < 3; ++round) {
    solve(size, z, trial_.data());
    const double length = norm(trial_.data(), size);
    if (!(length > 0) || !std::isfinite(length)) return std::numeric_limits<double>::infinity();
    // With y = (T + shift I)^-1 z, y'(T + shift I) y = y'z.
    curvature = dot(trial_.data(), z, size) / (length * length);
    for (std::size_t i = 0; i < size; ++i)
      z[i] = trial_[i] / length;
  }
  return curvature;
}

// The matrix in tridiagonal_ and the gradient in its coordinates, for minimise_in_ball().
void QuadraticStep::reduce(std::size_t size, const double* gradient) {
  double* matrix = tridiagonal_.matrix();
  const double magnitude = sum_of_magnitudes(gradient, size) + sum_of_magnitudes(matrix, size * size);
  tractable_ = magnitude < 1e250 && magnitude > 0;
  if (!tractable_) return;
  // Products of squares must neither vanish nor overflow.
  const double unit = magnitude < 1e-60 || magnitude > 1e60 ? 1 / magnitude : 1;
  for (std::size_t i = 0; unit != 1 && i < size * size; ++i)
    matrix[i] *= unit;
  tridiagonal_.reduce(size);
  for (std::size_t i = 0; i < size; ++i)
    gradient_[i] = gradient[i] * unit;
  slope_ = norm(gradient_.data(), size);
  tridiagonal_.to_reduced(gradient_.data());
}

// The reduced quadratic, multiplied by `sign`: into diagonal_ and below_ its matrix, into rotated_ minus its gradient.
void QuadraticStep::take_sign(double sign, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    diagonal_[i] = sign * tridiagonal_.diagonal()[i];
    if (i + 1 < size) below_[i] = sign * tridiagonal_.below()[i];
    rotated_[i] = -sign * gradient_[i];
  }
}

// Gershgorin's bounds of the eigenvalues, and from them of the shift.
QuadraticStep::Bracket QuadraticStep::bracket_of_shift(std::size_t size, double radius) const {
  double bottom = std::numeric_limits<double>::infinity(), top = -bottom, least = bottom;
  for (std::size_t i = 0; i < size; ++i) {
    const double reach = (i > 0 ? std::abs(below_[i - 1]) : 0.0) + (i + 1 < size ? std::abs(below_[i]) : 0.0);
    bottom = std::min(bottom, diagonal_[i] - reach);
    top = std::max(top, diagonal_[i] + reach);
    least = std::min(least, diagonal_[i]);
  }
  const double scale = std::max(std::abs(bottom), std::abs(top));
  return {.low = std::max({0.0, -least, slope_ / radius - top}),
          .high = std::max(slope_ / radius - bottom, 0.0) + 1e-12 * scale + 1e-300,
          .scale = scale};
}

// The next shift where T + shift I is not positive definite.
double QuadraticStep::raise_shift(Bracket& bracket, double shift, int iteration) {
  bracket.low = std::max(bracket.low, shift);
  shift = bracket.middle();
  if (shift <= bracket.low || shift > bracket.high)
    shift = bracket.low + std::max(1e-14 * bracket.scale, 1e-300) * (iteration + 1);
  bracket.high = std::max(bracket.high, shift);
  return shift;
}

// The hard case: s, of a length below the radius, gets t z, with z near the lowest eigenvector, so that it ends on the
// sphere, if that is good enough; how much worse than the best it can be is known (More and Sorensen, section 3.2).
// Returns whether it was.
bool QuadraticStep::add_lowest_direction(const Bracket& bracket, double shift, std::size_t size, double radius,
                                         double length, double* s) {
  double* z = derivative_.data();
  const double curvature = lowest_direction(size, z);
  const double along = dot(s, z, size), missing = radius * radius - length * length;
  const double root = std::sqrt(along * along + missing), t = missing / (along + (along < 0 ? -root : root));
  const double value = shift * radius * radius + dot(s, rotated_.data(), size);  // twice the model's reduction by s
  if (!(t * t * curvature <= accuracy_of_value * value || bracket.high - bracket.low <= 1e-14 * bracket.scale))
    return false;
  add_scaled(s, t, z, size);
  return true;
}

// More and Sorensen 1983, section 3: Newton's iteration for the shift at which |s(shift)| = radius on 1 / |s| - 1 /
// radius, which is nearly linear, within a bracket; where s stays short although T + shift I is nearly singular (the
// hard case), the lowest eigenvector is added.
void QuadraticStep::find_shift(std::size_t size, double radius, double* s) {
  Bracket bracket = bracket_of_shift(size, radius);
  double shift = bracket.low;
  double* z = derivative_.data();
  for (int iteration = 0; iteration < 100; ++iteration) {
    if (!factorise(size, shift)) {
      shift = raise_shift(bracket, shift, iteration);
      continue;
    }
    solve(size, rotated_.data(), s);
    const double length = norm(s, size);
    if (length <= radius && shift == 0) break;
    if (std::abs(length - radius) <= accuracy_of_length * radius) break;
    if (length > radius) {
      bracket.low = shift;
    } else {
      bracket.high = shift;
      if (add_lowest_direction(bracket, shift, size, radius, length, s)) break;
    }
    solve(size, s, z);
    shift += dot(s, s, size) / dot(s, z, size) * (length - radius) / radius;
    if (shift > bracket.low && shift < bracket.high) continue;
    shift = bracket.middle();
    if (!(shift > bracket.low && shift < bracket.high)) break;
  }
}

// The quadratic is multiplied by `sign`.
void QuadraticStep::minimise_in_ball(double sign, std::size_t size, double radius, double* s) {
  std::fill_n(s, size, 0.0);
  if (!tractable_ || !(radius > 0)) return;
  take_sign(sign, size);
  find_shift(size, radius, s);
  const double length = norm(s, size);
  if (!std::isfinite(length)) {
    std::fill_n(s, size, 0.0);
    return;
  }
  if (length > radius) {
    for (std::size_t i = 0; i < size; ++i)
      s[i] *= radius / length;
  }
  tridiagonal_.from_reduced(s);
}

}  // namespace orbicube::trust_region
