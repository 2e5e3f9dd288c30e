// Runs from several starts, one after the other: the given one, then random points of the spheres.
#include <algorithm>
#include <limits>

#include "base/random.h"
#include "sphere_optimizer/solver.h"
#include "sphere_optimizer/spheres.h"

namespace orbicube::sphere_optimizer {

using base::Request;

// Ends the run, or what follows from one of several starts, of which the lowest is kept.
Request Solver::end_start(Stop reason) {
  const bool limited =
      reason == Stop::target_reached || reason == Stop::evaluation_budget || reason == Stop::iteration_budget;
  if (limited || state_.start + 1 >= options_.starts) return state_.finish(reason);
  const double value = reason == Stop::converged ? state_.value : state_.best_value;
  if (value < state_.lowest.value) {
    state_.lowest = {state_.start, reason == Stop::converged ? 1U : 0U, value, state_.measure};
    const auto& point = reason == Stop::converged ? x_ : best_;
    std::copy(point.begin(), point.end(), lowest_point_.begin());
  }
  State next;
  next.evaluations = next.gained_at = state_.evaluations;
  next.failed_evaluations = state_.failed_evaluations;
  next.iterations = state_.iterations;
  next.start = state_.start + 1;
  next.lowest = state_.lowest;
  next.newton.products = state_.newton.products;
  state_ = next;
  memory_.clear();
  std::fill(last_values_.begin(), last_values_.end(), -std::numeric_limits<double>::infinity());
  place_random_start();
  return advance();
}

// Sums of twelve uniform numbers are nearly normal, so that the directions are nearly uniform, and without functions of
// the mathematical library they are the same on every machine.
void Solver::place_random_start() {
  constexpr int terms = 12;
  base::Random random(base::Random(options_.seed ^ base::Random(state_.start).next()).next());
  for_each_block([&](auto d, std::size_t i) {
    do {
      for (std::size_t k = i * d; k < (i + 1) * d; ++k) {
        x_[k] = -0.5 * terms;
        for (int term = 0; term < terms; ++term)
          x_[k] += random.unit();
      }
    } while (!normalize(d, &x_[i * d]));
  });
  std::copy(x_.begin(), x_.end(), best_.begin());
}

Result Solver::result() const {
  Result result;
  state_.describe(result);
  result.gradient_norm = state_.measure;
  result.products = state_.newton.products;
  result.starts = state_.phase == Phase::created ? state_.start : state_.start + 1;
  result.best_start = state_.start;
  if (earlier_is_lower()) {
    result.value = state_.lowest.value;
    result.gradient_norm = state_.lowest.measure;
    result.best_start = state_.lowest.start;
    const bool complete =
        state_.stop == Stop::converged || state_.stop == Stop::stalled || state_.stop == Stop::evaluation_failed;
    if (complete) result.stop = state_.lowest.converged != 0 ? Stop::converged : Stop::stalled;
  }
  return result;
}

}  // namespace orbicube::sphere_optimizer
