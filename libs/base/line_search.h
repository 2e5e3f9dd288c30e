// One-dimensional searches, a trial at a time, for a solver that requests from its caller every value.
//
// WolfeSearch: bracketing and safeguarded cubic steps to the weak Wolfe conditions, or for some trials to the strong
// ones, or, where f no longer resolves a decrease, Hager and Zhang's approximate ones (2005, "A new conjugate gradient
// method with guaranteed descent"). BacktrackingSearch: quadratic backtracking to a nonmonotone sufficient decrease,
// for the dissertation's method.
#pragma once

#include <array>
#include <cstdint>

namespace orbicube::base {

// endless: f falls along the direction as far as was looked, and no less steeply.
enum class Search : std::int32_t { again = 0, accept = 1, give_up = 2, endless = 3 };

// Plain data: saved and loaded as bytes.
struct WolfeSearch {
  double start_value, start_slope;      // f and its derivative along the direction at 0
  double level;                         // f may end this high where it no longer resolves a decrease
  double longest;                       // the direction may be followed this far
  double max_rise;                      // of the slope in the first trials' end, in units of -start_slope: the strong
                                        // Wolfe condition; start() sets infinity, the weak one
  double low, low_value, low_slope;     // the best point with a sufficient decrease, 0 at first
  double high, high_value, high_slope;  // beyond the requested point, where there is one (NaN values: f failed there)
  double length;                        // of the trial that is requested
  std::uint64_t trials, has_high, returning;
  std::uint64_t contradictions;                   // trials where f is higher though it falls at both ends by the slopes
  std::uint64_t unresolved;                       // trials that rounding of f does not tell from the start
  double contradicted_length, contradicted_rise;  // of the last contradiction
  std::uint64_t noisy;  // 1: f rises by as much at shorter lengths, which its slopes do not show
  double noise = 0;     // of f, as earlier searches saw it, which start() keeps: f may end this much higher

  // `lowest` is the minimum value so far; the first trial is at length 1.
  void start(double value, double lowest, double slope, double longest_length);
  // Takes f and its derivative at `length` (NaN: failed). again: evaluate at the new `length`.
  Search advance(double value, double slope);

 private:
  void count_doubts(double value, double slope);
  bool hopeless() const;
  bool leave_false_bracket(double slope);
};

struct BacktrackingSearch {
  double reference, start_slope, length;
  std::uint64_t trials;

  void start(double reference_value, double slope);
  Search advance(double start_value, double value);
};

}  // namespace orbicube::base
