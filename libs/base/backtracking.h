// Backtracking along a descent direction to a sufficient decrease (Armijo 1966; Nocedal and Wright 2006,
// algorithm 3.1), for functions that are evaluated in place. Where the caller supplies the values, one at a time, see
// line_search.h.
#pragma once

#include <optional>

namespace orbicube::base {

struct Backtracking {
  double first_length = 1;  // of the step in the first trial
  double factor = 0.5;      // from each length to the next, in (0, 1)
  int max_trials = 12;
  double decrease = 1e-4;  // fraction of the decrease that the slope predicts; 0: any decrease, with `strict`
  bool strict = false;     // the value must be below the bound; false: at most the bound
};

struct BacktrackingStep {
  double length;  // of the accepted step
  double value;   // of the function there
  int trials;     // 1: the first length was accepted
};

// Evaluates `value_at(length)` at shorter and shorter lengths and returns the first step whose value is at most
// value + decrease * length * slope and for which `allowed()`, called after such a value only, returns true. Returns
// nothing if no trial is accepted; values that are not numbers never are. `slope` is the derivative along the
// direction.
template <class ValueAt, class Allowed>
std::optional<BacktrackingStep> backtrack(double value, double slope, const Backtracking& rule, const ValueAt& value_at,
                                          const Allowed& allowed) {
  double length = rule.first_length;
  for (int trial = 1; trial <= rule.max_trials; ++trial, length *= rule.factor) {
    const double reached = value_at(length);
    const double bound = value + rule.decrease * length * slope;
    if ((rule.strict ? reached < bound : reached <= bound) && allowed())
      return BacktrackingStep{length, reached, trial};
  }
  return std::nullopt;
}

template <class ValueAt>
std::optional<BacktrackingStep> backtrack(double value, double slope, const Backtracking& rule,
                                          const ValueAt& value_at) {
  return backtrack(value, slope, rule, value_at, [] { return true; });
}

}  // namespace orbicube::base
