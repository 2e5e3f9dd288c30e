#include "projected_gradient/row_equation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "projected_gradient/vector_math.h"

namespace orbicube::projected_gradient {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Pass {
  double residual;   // left side minus rhs
  double magnitude;  // sum of |terms|, the scale of the rounding error
  double slope_up;   // derivative to the right and to the left: they differ where a variable leaves its bound
  double slope_down;
};

Pass evaluate(const RowEquation& e, double t) {
  constexpr std::size_t lanes = 4, block = 256;
  CompensatedSum sum;
  Pass pass{0, std::abs(e.rhs), 0, 0};
  const std::size_t n = e.a.size();
  for (std::size_t i = 0; i < n;) {
    const std::size_t end = std::min(n, i + block);
    std::array<double, lanes> left{}, magnitude{}, up{}, down{};
    const auto one = [&](std::size_t j, std::size_t k) {
      const double a = e.a[j], moved = e.y[j] + t * a, low = e.lower[j], high = e.upper[j];
      const double term = a * clip(moved, low, high);
      // An infinite bound that a zero coefficient meets cannot arise: the clipped value is finite whenever y is.
      const double square = a * a;
      const bool inside = moved > low && moved < high;
      const bool leaves_low = moved == low && low < high, leaves_high = moved == high && low < high;
      left[k] += term;
      magnitude[k] += std::abs(term);
      up[k] += inside || (a > 0 ? leaves_low : leaves_high) ? square : 0.0;
      down[k] += inside || (a > 0 ? leaves_high : leaves_low) ? square : 0.0;
    };
    for (; i + lanes <= end; i += lanes) {
      for (std::size_t k = 0; k < lanes; ++k)
        one(i + k, k);
    }
    for (std::size_t k = 0; i < end; ++i, ++k)
      one(i, k);
    sum.add((left[0] + left[1]) + (left[2] + left[3]));
    pass.magnitude += (magnitude[0] + magnitude[1]) + (magnitude[2] + magnitude[3]);
    pass.slope_up += (up[0] + up[1]) + (up[2] + up[3]);
    pass.slope_down += (down[0] + down[1]) + (down[2] + down[3]);
  }
  sum.add(-e.rhs);
  pass.residual = sum.value();
  return pass;
}

// The two values of t at which unknown j meets its bounds, in order; infinite where there is none.
std::array<double, 2> breakpoints(const RowEquation& e, std::size_t j) {
  if (e.a[j] == 0 || e.lower[j] == e.upper[j]) return {infinity, infinity};
  const double at_lower = (e.lower[j] - e.y[j]) / e.a[j], at_upper = (e.upper[j] - e.y[j]) / e.a[j];
  return {std::min(at_lower, at_upper), std::max(at_lower, at_upper)};
}

// On a flat piece: the nearest breakpoint beyond t in the direction of `sign`, or an infinity.
double next_breakpoint(const RowEquation& e, double t, double sign) {
  double best = infinity;
  for (std::size_t j = 0; j < e.a.size(); ++j) {
    for (const double point : breakpoints(e, j)) {
      const double distance = sign * (point - t);
      if (distance > 0) best = std::min(best, distance);
    }
  }
  return t + sign * best;
}

// The median of up to 512 breakpoints inside (low, high), from unknowns spread evenly; low when there is none.
double middle_breakpoint(const RowEquation& e, double low, double high) {
  std::array<double, 1024> sample;
  std::size_t count = 0;
  const std::size_t n = e.a.size(), stride = n / 512 + 1;
  // Each phase is a fresh set of unknowns; mostly the first already holds some.
  for (std::size_t phase = 0; phase < stride && count == 0; ++phase) {
    for (std::size_t j = phase; j < n; j += stride) {
      for (const double point : breakpoints(e, j)) {
        if (point > low && point < high && count < sample.size()) sample[count++] = point;
      }
    }
  }
  if (count == 0) return low;
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(sample.begin(), middle, sample.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}

}  // namespace

RowRoot solve_row_equation(const RowEquation& equation, double start, double accuracy) {
  constexpr std::uint32_t pass_limit = 400;
  double low = -infinity, high = infinity, low_residual = -infinity, high_residual = infinity;
  double previous = infinity;
  RowRoot root;
  root.t = std::isfinite(start) ? start : 0;
  RowRoot best = root;
  best.residual = infinity;
  while (root.passes < pass_limit) {
    const Pass pass = evaluate(equation, root.t);
    ++root.passes;
    root.residual = pass.residual;
    if (std::abs(root.residual) < std::abs(best.residual)) best = root;
    if (std::abs(root.residual) <= std::max(accuracy, 2 * epsilon * pass.magnitude)) return root;

    const double sign = root.residual < 0 ? 1 : -1;
    if (sign > 0) {
      low = root.t;
      low_residual = root.residual;
    } else {
      high = root.t;
      high_residual = root.residual;
    }
    const double slope = sign > 0 ? pass.slope_up : pass.slope_down;
    double candidate = slope > 0 ? root.t - root.residual / slope : infinity;
    if (!std::isfinite(candidate)) {
      candidate = next_breakpoint(equation, root.t, sign);
      ++root.passes;
      if (!std::isfinite(candidate)) {
        root.feasible = false;
        return root;
      }
    }
    const bool bracketed = std::isfinite(low) && std::isfinite(high);
    const bool slow = std::abs(root.residual) > 0.5 * previous;
    if (bracketed && (slow || !(candidate > low && candidate < high))) {
      // Newton left the bracket or hardly gains: take the chord, and when that too is no help halve the breakpoints.
      candidate = low - low_residual * ((high - low) / (high_residual - low_residual));
      if (slow || !(candidate > low && candidate < high)) {
        const double middle = middle_breakpoint(equation, low, high);
        // No breakpoint between: the function is one piece there, and the chord is exact.
        if (middle > low) candidate = middle;
      }
    }
    previous = std::abs(root.residual);
    const bool resolved = candidate == root.t || (bracketed && !(candidate > low && candidate < high));
    if (resolved) break;
    root.t = candidate;
  }
  best.passes = root.passes;
  return best;
}

}  // namespace orbicube::projected_gradient
