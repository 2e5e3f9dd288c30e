#include "base/line_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbicube::base {
namespace {

// Where the cubic through two values and slopes is least (Nocedal and Wright 2006, eq. 3.59); NaN if nowhere.
double cubic_minimiser(double a, double value_a, double slope_a, double b, double value_b, double slope_b) {
  const double first = slope_a + slope_b - 3 * (value_a - value_b) / (a - b);
  const double square = first * first - slope_a * slope_b;
  if (!(square >= 0)) return std::numeric_limits<double>::quiet_NaN();
  const double second = std::copysign(std::sqrt(square), b - a);
  return b - (b - a) * ((slope_b + second - first) / (slope_b - slope_a + 2 * second));
}

}  // namespace

void WolfeSearch::start(double value, double lowest, double slope, double longest_length) {
  constexpr double rounding = 1e-12;  // of f, relative: what sums over many unknowns leave
  constexpr double max_noise = 1e-8;  // relative: beyond it, values are needed
  const double known = std::min(noise, max_noise * std::abs(value));
  *this = WolfeSearch{};
  noise = known;
  start_value = low_value = value;
  start_slope = low_slope = slope;
  longest = longest_length;
  max_rise = std::numeric_limits<double>::infinity();
  length = 1;
  level = lowest + std::max(rounding * std::abs(lowest), noise);
}

void WolfeSearch::count_doubts(double value, double slope) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
  constexpr std::uint64_t early_trials = 4;
  const double rise = value - start_value;
  if (std::abs(rise) <= rounding * std::abs(start_value)) {
    ++unresolved;
  } else if (rise > 0 && slope < 0.5 * start_slope) {
    // What a wrong gradient makes f rise by falls with the length; what noise of f makes it rise by does not.
    if (contradictions > 0 && length < contradicted_length &&
        rise > std::sqrt(length / contradicted_length) * contradicted_rise) {
      noisy = 1;
      // At lengths near the first one; at the shortest ones, the rounding of the point is seen.
      if (trials <= early_trials) noise = std::max(noise, 2 * std::max(rise, contradicted_rise));
      level = std::max(level, start_value + noise);
    }
    ++contradictions;
    contradicted_length = length;
    contradicted_rise = rise;
  }
}

// A smooth f agrees with its slopes once trials are close to the start; a gradient that is wrong, differenced or
// rounded never does. Nor do slopes help for long where values do not. Noise of f says nothing against the slopes: then
// the bracket is followed to its end, and the run counts what searches gain.
bool WolfeSearch::hopeless() const {
  constexpr std::uint64_t max_contradictions = 8, max_unresolved = 10;
  return noisy == 0 && (contradictions >= max_contradictions || unresolved >= max_unresolved);
}

// Where only noise made the far end of the bracket higher, and f falls there by its slope: that end is the best point,
// and the next trial beyond it. False where there is no such end.
bool WolfeSearch::leave_false_bracket(double slope) {
  if (noise == 0 || !has_high || !(high_slope < 0) || !(high_value <= level) || !(high < longest)) return false;
  const double secant = high_slope > slope ? high - high_slope * (high - length) / (high_slope - slope)
                                           : std::numeric_limits<double>::infinity();
  low = high;
  low_value = high_value;
  low_slope = high_slope;
  has_high = 0;
  length = std::min(longest, std::clamp(secant, 2 * low, 10 * low));
  return true;
}

Search WolfeSearch::advance(double value, double slope) {
  constexpr double decrease = 1e-4, curvature = 0.9;
  constexpr std::uint64_t trial_limit = 30, max_flattening = 5;
  constexpr double endless_length = 1e15;
  ++trials;
  const bool finite = std::isfinite(value) && std::isfinite(slope);
  if (returning) return finite && (value < start_value || noisy != 0) ? Search::accept : Search::give_up;
  const bool lower = value <= start_value + decrease * length * start_slope;
  bool not_higher = value <= level;
  const bool flat_enough = slope >= curvature * start_slope;
  const bool rises = slope > -max_rise * start_slope && trials <= max_flattening;
  if (finite && !rises) {
    if (flat_enough && (lower || (not_higher && slope <= (2 * decrease - 1) * start_slope))) return Search::accept;
    if (!flat_enough && lower && length >= longest) return Search::accept;
  }
  if (finite) count_doubts(value, slope);
  not_higher = value <= level;
  if (finite && leave_false_bracket(slope)) return Search::again;
  if (trials >= trial_limit && !has_high && low >= endless_length) return Search::endless;
  if (trials >= trial_limit || hopeless() || (has_high && high - low <= 1e-15 * high)) {
    if (!(low > 0) || !(low_value < start_value || noisy != 0)) return Search::give_up;
    returning = 1;
    length = low;
    return Search::again;
  }
  if (finite && !flat_enough && (lower || not_higher)) {
    const double previous = low;
    const double previous_slope = low_slope;
    low = length;
    low_value = value;
    low_slope = slope;
    if (!has_high) {
      // Still falling: follow the secant of the slopes, two to ten times as far.
      const double secant = slope > previous_slope ? length - slope * (length - previous) / (slope - previous_slope)
                                                   : std::numeric_limits<double>::infinity();
      length = std::min(longest, std::clamp(secant, 2 * length, 10 * length));
      return Search::again;
    }
  } else {
    has_high = 1;
    high = length;
    high_value = finite ? value : std::numeric_limits<double>::quiet_NaN();
    high_slope = slope;
  }
  const double width = high - low;
  // Where rounding hides the difference of the values, the slopes still tell.
  const bool resolved = std::abs(high_value - low_value) > std::max(1e-12 * std::abs(start_value), noise);
  const double guess = resolved ? cubic_minimiser(low, low_value, low_slope, high, high_value, high_slope)
                                : low - low_slope * width / (high_slope - low_slope);
  // After failures of f the way back is short first and long when they go on.
  const double otherwise = std::isfinite(high_value) ? 0.5 : 0.25;
  length = std::isfinite(guess) ? std::clamp(guess, low + 0.1 * width, high - 0.1 * width) : low + otherwise * width;
  return Search::again;
}

void BacktrackingSearch::start(double reference_value, double slope) {
  reference = reference_value;
  start_slope = slope;
  length = 1;
  trials = 0;
}

Search BacktrackingSearch::advance(double start_value, double value) {
  constexpr double decrease = 1e-4;
  constexpr std::uint64_t trial_limit = 60;
  ++trials;
  if (value <= reference + decrease * length * start_slope) return Search::accept;
  if (trials >= trial_limit) return Search::give_up;
  // The parabola through the start, its slope and this value; NaN (f failed) ends in the middle of the range.
  const double guess = -0.5 * length * length * start_slope / (value - start_value - length * start_slope);
  length = std::isfinite(guess) ? std::clamp(guess, 0.1 * length, 0.5 * length) : 0.25 * length;
  return Search::again;
}

}  // namespace orbicube::base
