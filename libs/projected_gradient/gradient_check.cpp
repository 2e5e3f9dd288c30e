#include "projected_gradient/gradient_check.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/array.h"
#include "base/error.h"
#include "base/infinity.h"
#include "base/sums.h"

namespace orbicube::projected_gradient {

using base::require;

namespace {

// Of the unknown: between the error of a central difference, which is in proportion to the square of the step, and the
// rounding of f, which is in proportion to its inverse.
constexpr double relative_step = 1e-5;
// Of a narrow box.
constexpr double part_of_box = 0.05;
// An error counts when it is larger than this many uncertainties, and than this fraction of the entry.
constexpr double uncertainties = 5, tolerance = 1e-4;
// A difference is resolved when its uncertainty is a smaller part of it.
constexpr double resolved = 1e-2;

struct Difference {
  double value = std::numeric_limits<double>::quiet_NaN();
  double uncertainty = base::infinity;
};

struct Checked {
  base::Array<double>& at;
  const ValueAndGradient& f;
  const base::Host& host;
  double center = 0;  // f there
  std::size_t evaluations = 0;

  double value(std::size_t j, double x) {
    const double before = at[j];
    at[j] = x;
    host.report("gradient check", evaluations++, 0);
    const double result = f(at.data(), nullptr);
    at[j] = before;
    return result;
  }

  // By steps of `length` and twice that: central, or to one side where the other has no room or no value.
  Difference difference(std::size_t j, double length, double low, double high) {
    const double x = at[j];
    const auto rounding = [](double a, double b, double across) {
      return 4 * std::numeric_limits<double>::epsilon() * (std::abs(a) + std::abs(b)) / across;
    };
    Difference best;
    if (x - 2 * length >= low && x + 2 * length <= high) {
      const double up = x + length, down = x - length, farther_up = x + 2 * length, farther_down = x - 2 * length;
      const double a = value(j, up), b = value(j, down), c = value(j, farther_up), d = value(j, farther_down);
      best.value = (a - b) / (up - down);
      best.uncertainty = std::abs(best.value - (c - d) / (farther_up - farther_down)) + rounding(a, b, up - down);
      if (std::isfinite(best.value) && std::isfinite(best.uncertainty)) return best;
    }
    best = {};
    for (const double side : {1.0, -1.0}) {
      const double near = x + side * length, far = x + 2 * side * length;
      if (far < low || far > high) continue;
      const double a = value(j, near), b = value(j, far);
      // The parabola through three values; its error is about what it differs from the line by, times the step.
      const double first = (a - center) / (near - x), second = (b - a) / (far - near);
      const double slope = 1.5 * first - 0.5 * second;
      const double uncertainty = 0.1 * std::abs(second - first) + rounding(a, center, length);
      if (std::isfinite(slope) && uncertainty < best.uncertainty) best = {slope, uncertainty};
    }
    return best;
  }
};

}  // namespace

GradientCheck check_gradient(const Problem& problem, std::span<const double> x, const ValueAndGradient& f,
                             const base::Host& host) {
  const std::size_t n = problem.n;
  require(n >= 1 && x.size() == n && base::all_finite(x), "x must be n finite numbers");
  const auto low = [&](std::size_t j) { return problem.lower.empty() ? -base::infinity : problem.lower[j]; };
  const auto high = [&](std::size_t j) { return problem.upper.empty() ? base::infinity : problem.upper[j]; };
  base::Array<double> at(n, 0.0, host.memory), gradient(n, std::numeric_limits<double>::quiet_NaN(), host.memory);
  for (std::size_t j = 0; j < n; ++j) {
    require(low(j) <= high(j), "a lower bound is above its upper bound, or not a number");
    at[j] = std::clamp(x[j], low(j), high(j));
  }
  Checked checked{at, f, host};
  checked.center = f(at.data(), gradient.data());
  checked.evaluations = 1;
  require(std::isfinite(checked.center) && base::all_finite(gradient), "f has no value or no gradient at x");
  GradientCheck result;
  result.agrees = true;
  double worst = -1;
  for (std::size_t j = 0; j < n; ++j) {
    const double width = high(j) - low(j);
    if (!(width > 0)) continue;  // fixed
    const double unit = std::min(1.0, width), own = at[j] != 0 ? std::abs(at[j]) : unit;
    const auto step = [&](double magnitude) { return std::min(relative_step * magnitude, part_of_box * width); };
    Difference found = checked.difference(j, step(own), low(j), high(j));
    if (own != unit && !(found.uncertainty <= resolved * std::abs(found.value))) {
      const Difference other = checked.difference(j, step(unit), low(j), high(j));
      if (other.uncertainty < found.uncertainty) found = other;
    }
    if (!std::isfinite(found.value)) continue;
    ++result.compared;
    const double apart = std::abs(gradient[j] - found.value);
    const double size = std::max({std::abs(gradient[j]), std::abs(found.value), std::numeric_limits<double>::min()});
    const double error = std::max(0.0, apart - uncertainties * found.uncertainty) / size;
    result.agrees = result.agrees && error <= tolerance;
    if (error > worst) {
      worst = error;
      result.worst = j;
      result.told = gradient[j];
      result.difference = found.value;
      result.error = error;
      result.uncertainty = found.uncertainty;
    }
  }
  result.evaluations = checked.evaluations;
  return result;
}

}  // namespace orbicube::projected_gradient
