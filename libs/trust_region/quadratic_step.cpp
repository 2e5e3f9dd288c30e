#include "trust_region/quadratic_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trust_region/dense.h"

namespace orbicube::trust_region {

QuadraticStep::QuadraticStep(std::size_t n, std::pmr::memory_resource* memory)
    : n_(n),
      reduced_(n * n, 0.0, memory),
      diagonal_(n, 0.0, memory),
      below_(n, 0.0, memory),
      factor_(n, 0.0, memory),
      pivots_(n, 0.0, memory),
      rotated_(n, 0.0, memory),
      trial_(n, 0.0, memory),
      derivative_(n, 0.0, memory),
      free_gradient_(n, 0.0, memory),
      free_step_(n, 0.0, memory),
      free_(n, 0, memory),
      fixed_(n, 0, memory) {}

void QuadraticStep::minimise(const double* gradient, const double* matrix, double radius, const double* lower,
                             const double* upper, double* s) {
  std::fill_n(s, n_, 0.0);
  if (lower == nullptr) {
    std::copy_n(matrix, n_ * n_, reduced_.data());
    minimise_in_ball(n_, gradient, radius, s);
    return;
  }
  for (std::size_t i = 0; i < n_; ++i) {
    fixed_[i] = (lower[i] >= 0 && gradient[i] >= 0) || (upper[i] <= 0 && gradient[i] <= 0) ? 1 : 0;
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
        reduced_[a * count + b] = row[free_[b]];
    }
    minimise_in_ball(count, free_gradient_.data(), std::sqrt(left), free_step_.data());
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

// Householder's reduction of reduced_ (size x size): reflector k in row k beyond the diagonal, its 2 / v'v in factor_.
void QuadraticStep::to_tridiagonal(std::size_t size) {
  double* p = trial_.data();
  for (std::size_t k = 0; k + 2 < size; ++k) {
    double* v = reduced_.data() + k * size + k + 1;
    const std::size_t rest = size - k - 1;
    diagonal_[k] = reduced_[k * size + k];
    const double tail = dot(v + 1, v + 1, rest - 1), length = std::sqrt(tail + v[0] * v[0]);
    factor_[k] = 0;
    below_[k] = v[0];
    if (!(tail > 0)) continue;
    below_[k] = v[0] > 0 ? -length : length;
    v[0] -= below_[k];
    factor_[k] = 2 / (tail + v[0] * v[0]);
    double* sub = reduced_.data() + (k + 1) * size + k + 1;
    multiply(sub, size, rest, rest, v, p);
    const double half = 0.5 * factor_[k] * factor_[k] * dot(v, p, rest);
    for (std::size_t i = 0; i < rest; ++i)
      p[i] = factor_[k] * p[i] - half * v[i];
    for (std::size_t i = 0; i < rest; ++i) {
      double* row = sub + i * size;
      const double a = v[i], b = p[i];
      for (std::size_t j = 0; j < rest; ++j)
        row[j] -= a * p[j] + b * v[j];
    }
  }
  if (size >= 2) {
    diagonal_[size - 2] = reduced_[(size - 2) * size + size - 2];
    below_[size - 2] = reduced_[(size - 2) * size + size - 1];
    factor_[size - 2] = 0;
  }
  diagonal_[size - 1] = reduced_[size * size - 1];
}

// (T + shift I) x = right by LDL'; false unless the matrix is positive definite.
bool QuadraticStep::solve(std::size_t size, double shift, const double* right, double* x) {
  double pivot = diagonal_[0] + shift;
  for (std::size_t i = 0;; ++i) {
    if (!(pivot > 0)) return false;
    pivots_[i] = pivot;
    x[i] = right[i] - (i > 0 ? below_[i - 1] / pivots_[i - 1] * x[i - 1] : 0.0);
    if (i + 1 == size) break;
    pivot = diagonal_[i + 1] + shift - below_[i] * (below_[i] / pivot);
  }
  for (std::size_t i = size; i-- > 0;)
    x[i] = x[i] / pivots_[i] - (i + 1 < size ? below_[i] / pivots_[i] * x[i + 1] : 0.0);
  return true;
}

// From below, to rounding: bisection between Gershgorin's bound and the least diagonal entry.
double QuadraticStep::lowest_eigenvalue(std::size_t size) const {
  double low = std::numeric_limits<double>::infinity(), high = low, scale = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const double reach = (i > 0 ? std::abs(below_[i - 1]) : 0.0) + (i + 1 < size ? std::abs(below_[i]) : 0.0);
    low = std::min(low, diagonal_[i] - reach);
    high = std::min(high, diagonal_[i]);
    scale = std::max(scale, std::abs(diagonal_[i]) + reach);
  }
  while (high - low > 1e-14 * scale) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    double pivot = diagonal_[0] - middle;
    bool above = pivot > 0;
    for (std::size_t i = 1; above && i < size; ++i) {
      pivot = diagonal_[i] - middle - below_[i - 1] * (below_[i - 1] / pivot);
      above = pivot > 0;
    }
    (above ? low : high) = middle;
  }
  return low;
}

// s + t z with z the eigenvector of the lowest eigenvalue and |s + t z| = radius, t the smaller of two.
void QuadraticStep::add_lowest_direction(std::size_t size, double shift, double radius, double* s) {
  double* z = derivative_.data();
  for (std::size_t i = 0; i < size; ++i)
    z[i] = 1 / static_cast<double>(i + 2);
  for (int round = 0; round < 3; ++round) {
    if (!solve(size, shift, z, trial_.data())) return;
    const double length = norm(trial_.data(), size);
    if (!(length > 0) || !std::isfinite(length)) return;
    for (std::size_t i = 0; i < size; ++i)
      z[i] = trial_[i] / length;
  }
  const double along = dot(s, z, size), missing = radius * radius - dot(s, s, size);
  if (!(missing > 0)) return;
  const double root = std::sqrt(along * along + missing);
  add_scaled(s, missing / (along + (along < 0 ? -root : root)), z, size);
}

// Of the matrix in reduced_, which is lost.
void QuadraticStep::minimise_in_ball(std::size_t size, const double* gradient, double radius, double* s) {
  std::fill_n(s, size, 0.0);
  const double slope = norm(gradient, size);
  double magnitude = slope;
  for (std::size_t i = 0; i < size * size; ++i)
    magnitude += std::abs(reduced_[i]);
  if (!(magnitude < 1e150) || !(radius > 0)) return;  // squares are still finite
  to_tridiagonal(size);
  double* right = rotated_.data();
  for (std::size_t i = 0; i < size; ++i)
    right[i] = -gradient[i];
  for (std::size_t k = 0; k + 2 < size; ++k) {
    const double* v = reduced_.data() + k * size + k + 1;
    if (factor_[k] != 0) add_scaled(right + k + 1, -factor_[k] * dot(v, right + k + 1, size - k - 1), v, size - k - 1);
  }

  double scale = 0;
  for (std::size_t i = 0; i < size; ++i)
    scale = std::max({scale, std::abs(diagonal_[i]), i + 1 < size ? std::abs(below_[i]) : 0.0});
  double low = 0, shift = 0;
  bool definite = solve(size, 0, right, s);
  for (std::size_t i = 0; definite && i < size; ++i)
    definite = pivots_[i] > 1e-14 * scale;
  if (!definite) {
    // The least shift at which the matrix is safely positive definite.
    low = std::max(0.0, -lowest_eigenvalue(size));
    double margin = std::max(1e-13 * scale, 1e-300);
    for (shift = low + margin; !solve(size, shift, right, s); shift = low + margin) {
      if (!(shift < 1e200)) {
        std::fill_n(s, size, 0.0);
        return;
      }
      margin *= 4;
    }
  }
  double length = norm(s, size);
  if (length < radius) {
    if (!definite) add_lowest_direction(size, shift, radius, s);
  } else {
    // |s(shift)| = radius: Newton's iteration on 1 / |s| - 1 / radius, which is nearly linear, within a bracket.
    double high = slope / radius + low + scale * 1e-12;
    low = shift;
    for (int iteration = 0; iteration < 60 && std::abs(length - radius) > 1e-9 * radius; ++iteration) {
      (length > radius ? low : high) = shift;
      double next = 0.5 * (low + high);
      if (solve(size, shift, s, derivative_.data())) {
        const double change = dot(s, s, size) / dot(s, derivative_.data(), size) * (length - radius) / radius;
        if (shift + change > low && shift + change < high) next = shift + change;
      }
      if (next <= low || next >= high) break;
      shift = next;
      if (!solve(size, shift, right, s)) {
        low = shift;
        length = std::numeric_limits<double>::infinity();
        continue;
      }
      length = norm(s, size);
    }
    if (!std::isfinite(length)) solve(size, high, right, s);
    length = norm(s, size);
    if (length > radius) {
      for (std::size_t i = 0; i < size; ++i)
        s[i] *= radius / length;
    }
  }
  for (std::size_t k = size; k-- > 0;) {
    if (k + 2 >= size || factor_[k] == 0) continue;
    const double* v = reduced_.data() + k * size + k + 1;
    add_scaled(s + k + 1, -factor_[k] * dot(v, s + k + 1, size - k - 1), v, size - k - 1);
  }
}

}  // namespace orbicube::trust_region
