// One-dimensional searches, a trial at a time, for a solver that asks its caller for every value.
//
// WolfeSearch: bracketing and safeguarded cubic steps to the weak Wolfe conditions or, where f no longer resolves a
// decrease, Hager and Zhang's approximate ones (2005, "A new conjugate gradient method with guaranteed descent").
// BacktrackingSearch: quadratic backtracking to a nonmonotone sufficient decrease, for the dissertation's method.
#pragma once

#include <array>
#include <cstdint>

namespace orbicube::base {

enum class Search : std::int32_t { again = 0, accept = 1, give_up = 2 };

// Plain data: saved and loaded as bytes.
struct WolfeSearch {
  double start_value, start_slope;      // f and its derivative along the direction at 0
  double level;                         // f may end this high where it no longer resolves a decrease
  double longest;                       // the direction may be followed this far
  double low, low_value, low_slope;     // the best point with a sufficient decrease, 0 at first
  double high, high_value, high_slope;  // beyond the wanted point, where there is one (NaN values: f failed there)
  double length;                        // of the trial that is asked for
  std::uint64_t trials, has_high, returning;

  // `lowest` is the least value so far; the first trial is at length 1.
  void start(double value, double lowest, double slope, double longest_length);
  // Takes f and its derivative at `length` (NaN: failed). again: evaluate at the new `length`.
  Search advance(double value, double slope);
};

struct BacktrackingSearch {
  double reference, start_slope, length;
  std::uint64_t trials;

  void start(double reference_value, double slope);
  Search advance(double start_value, double value);
};

}  // namespace orbicube::base
