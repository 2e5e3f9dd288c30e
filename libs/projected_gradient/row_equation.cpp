#include "projected_gradient/row_equation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/infinity.h"
#include "projected_gradient/vector_math.h"

namespace orbicube::projected_gradient {
namespace {

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
  if (e.a[j] == 0 || e.lower[j] == e.upper[j]) return {base::infinity, base::infinity};
  const double at_lower = (e.lower[j] - e.y[j]) / e.a[j], at_upper = (e.upper[j] - e.y[j]) / e.a[j];
  return {std::min(at_lower, at_upper), std::max(at_lower, at_upper)};
}

// The nearest breakpoint beyond t in the direction of `sign`, and a little more; infinity when there is none.
double next_breakpoint(const RowEquation& e, double t, double sign) {
  double best = base::infinity;
  for (std::size_t j = 0; j < e.a.size(); ++j) {
    for (const double point : breakpoints(e, j)) {
      const double distance = sign * (point - t);
      if (distance > 0) best = std::min(best, distance);
    }
  }
  // A little more, so that rounding does not leave t on the flat side.
  return t + sign * best * (1 + 1e-10);
}

constexpr std::size_t sample_size = 1024;

// Where the residual, known at t, would vanish if all unknowns moved as the sampled ones do; NaN when they cannot tell.
double sampled_root(const RowEquation& e, double t, double residual, double low, double high) {
  std::array<double, 2 * sample_size> kept;
  std::size_t count = 0;
  const std::size_t n = e.a.size(), stride = (n + sample_size - 1) / sample_size;
  const double from = residual < 0 ? t : low, to = residual < 0 ? high : t;
  for (std::size_t j = 0; j < n; j += stride) {
    for (const double point : breakpoints(e, j)) {
      if (point > from && point < to) kept[count++] = point;
    }
  }
  if (count == 0) return std::numeric_limits<double>::quiet_NaN();
  const std::span<double> points(kept.data(), count);
  std::sort(points.begin(), points.end());
  const double weight = static_cast<double>(stride);
  const auto predicted = [&](double at) {
    double change = 0;
    for (std::size_t j = 0; j < n; j += stride) {
      const double a = e.a[j];
      change += a * (clip(e.y[j] + at * a, e.lower[j], e.upper[j]) - clip(e.y[j] + t * a, e.lower[j], e.upper[j]));
    }
    return residual + weight * change;
  };
  // The first breakpoint at or beyond the predicted root.
  std::size_t below = 0, above = points.size();
  while (below < above) {
    const std::size_t middle = (below + above) / 2;
    if (predicted(points[middle]) < 0) {
      below = middle + 1;
    } else {
      above = middle;
    }
  }
  const double left = below == 0 ? (residual < 0 ? t : low) : points[below - 1];
  const double right = below == points.size() ? (residual < 0 ? high : t) : points[below];
  // Beyond the outermost breakpoint, by a little more than rounding, so that its unknown moves there.
  if (!std::isfinite(left)) return right + 1e-10 * (right - t);
  if (!std::isfinite(right)) return left + 1e-10 * (left - t);
  const double at_left = predicted(left), at_right = predicted(right);
  if (!(at_right > at_left)) return 0.5 * (left + right);
  return std::clamp(left - at_left * ((right - left) / (at_right - at_left)), left, right);
}

// One pass over the breakpoints inside (low, high). Where they are few, the root itself: the function is followed from
// low, piece by piece. Else the middle one of those kept, every second, fourth, ... of them all.
double breakpoint_inside(const RowEquation& e, double low, double low_residual, double low_slope, double high) {
  struct Breakpoint {
    double t, slope_change;
  };
  std::array<Breakpoint, 2048> kept;
  std::size_t count = 0, seen = 0, every = 1;
  for (std::size_t j = 0; j < e.a.size(); ++j) {
    const std::array<double, 2> points = breakpoints(e, j);
    for (const bool leaves : {false, true}) {
      const double t = points[leaves];
      if (!(t > low && t < high) || seen++ % every != 0) continue;
      if (count == kept.size()) {
        for (std::size_t k = 0; k < count / 2; ++k)
          kept[k] = kept[2 * k];
        count /= 2;
        every *= 2;
        if ((seen - 1) % every != 0) continue;
      }
      kept[count++] = {t, leaves ? -e.a[j] * e.a[j] : e.a[j] * e.a[j]};
    }
  }
  const std::span<Breakpoint> points(kept.data(), count);
  const auto earlier = [](const Breakpoint& x, const Breakpoint& y) { return x.t < y.t; };
  if (every > 1) {
    const auto middle = points.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(points.begin(), middle, points.end(), earlier);
    return middle->t;
  }
  std::sort(points.begin(), points.end(), earlier);
  double t = low, residual = low_residual, slope = low_slope;
  for (const Breakpoint& point : points) {
    const double next = residual + slope * (point.t - t);
    if (next >= 0) break;
    residual = next;
    t = point.t;
    slope += point.slope_change;
  }
  return slope > 0 ? t - residual / slope : t;
}

}  // namespace

RowRoot solve_row_equation(const RowEquation& equation, double start, double accuracy) {
  constexpr std::uint32_t pass_limit = 400;
  double low = -base::infinity, high = base::infinity;
  double low_residual = 0, high_residual = 0, low_slope = 0;
  double previous = base::infinity;
  int slow = 0;  // passes in a row that did not halve the residual
  RowRoot root;
  root.t = std::isfinite(start) ? start : 0;
  RowRoot best = root;
  best.residual = base::infinity;
  while (root.passes < pass_limit) {
    const Pass pass = evaluate(equation, root.t);
    ++root.passes;
    root.residual = pass.residual;
    if (std::abs(root.residual) < std::abs(best.residual)) best = root;
    if (std::abs(root.residual) <= std::max(accuracy, 2 * epsilon * pass.magnitude)) return root;

    const double sign = root.residual < 0 ? 1 : -1;
    (sign > 0 ? low : high) = root.t;
    (sign > 0 ? low_residual : high_residual) = root.residual;
    if (sign > 0) low_slope = pass.slope_up;
    slow = std::abs(root.residual) > 0.5 * previous ? slow + 1 : 0;
    previous = std::abs(root.residual);

    const bool bracketed = std::isfinite(low) && std::isfinite(high);
    const auto usable = [&](double t) { return std::isfinite(t) && t > low && t < high; };
    // Newton's step; where that gains little, the root of a sample until there is a bracket, then its chord and, when
    // that gains little too, what its breakpoints tell.
    const double slope = sign > 0 ? pass.slope_up : pass.slope_down;
    double candidate = slope > 0 ? root.t - root.residual / slope : base::infinity;
    if (slow > 0 || !usable(candidate)) {
      if (!bracketed) {
        candidate = sampled_root(equation, root.t, root.residual, low, high);
      } else {
        candidate = low - low_residual * ((high - low) / (high_residual - low_residual));
        if ((slow > 0 && slow % 2 == 0) || !usable(candidate)) {
          candidate = breakpoint_inside(equation, low, low_residual, low_slope, high);
          ++root.passes;
        }
      }
    }
    if (!bracketed && !usable(candidate)) {
      candidate = slope > 0 ? root.t - root.residual / slope : base::infinity;
      if (!std::isfinite(candidate)) {
        candidate = next_breakpoint(equation, root.t, sign);
        ++root.passes;
      }
      if (!std::isfinite(candidate)) {
        root.feasible = false;
        return root;
      }
    }
    if (!usable(candidate)) break;  // neighboring numbers
    root.t = candidate;
  }
  best.passes = root.passes;
  return best;
}

}  // namespace orbicube::projected_gradient
