// What a quadratic f allows: between a point and a trial its value and gradient are known everywhere, so that an
// iteration goes on from the exact minimum along its direction without an evaluation there. With exact minima and a
// steady sigma, steps in a face are those of conjugate gradients.
#include <algorithm>
#include <cmath>
#include <limits>

#include "projected_gradient/solver.h"
#include "projected_gradient/vector_math.h"

namespace orbicube::projected_gradient {
namespace {

// Searches in a row whose trials agree with a quadratic before f counts as one.
constexpr std::uint64_t enough_trials = 2;
// How far the change of f may be from the mean of the slopes, in units of both slopes' magnitudes. Beyond
// `contradiction` f is not quadratic for the rest of the run, though it may look so in short steps; between the two, it
// may be rounding.
constexpr double agreement = 1e-9, contradiction = 1e-6;
constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
// Of |f|: smaller slopes are lost in the rounding of f, and say nothing for or against.
constexpr double visible_slopes = 1e-6, value_rounding = 1e-14;
// Of the trial's length: beyond them, the minimum is left to the search.
constexpr double shortest_minimum = 0.05, longest_minimum = 3;
// Of the values that an interpolated one is computed from: a smaller one would be their rounding.
constexpr double smallest_value = 1e-3;
// A trial within this part of its length from the minimum is as good.
constexpr double near_enough = 1e-3;

}  // namespace

// Where along the step to the trial, of `length` in units of direction_ and with the slope `slope` at its end, f is
// least, as a multiple of the step; 0 where f is not known to be quadratic, or the minimum is too far away.
double Solver::length_to_minimum(double length, double slope) {
  const double start = length * state_.wolfe.start_slope, end = length * slope;
  const double size = std::abs(start) + std::abs(end), scale = std::abs(state_.value);
  if (state_.quadratic == never || !std::isfinite(state_.trial_value) || !std::isfinite(slope)) return 0;
  if (size > visible_slopes * scale) {
    const double error = std::abs(state_.trial_value - state_.value - 0.5 * (start + end));
    const bool agrees = error <= agreement * size + value_rounding * scale;
    const bool first = state_.wolfe.trials == 0;  // further ones speak of the same line
    if (!agrees)
      state_.quadratic = error > contradiction * size ? never : 0;
    else if (first)
      ++state_.quadratic;
  }
  if (state_.quadratic == never || state_.quadratic < enough_trials || !(end > start)) return 0;
  const double room = state_.wolfe.longest / length;
  const double minimum = std::min(-start / (end - start), std::max(room, 1.0));
  // A shorter step would leave the bounds that the trial has reached.
  if (minimum < 1 && room <= 1) return 0;
  const double value = state_.value + minimum * (start + 0.5 * minimum * (end - start));
  if (std::abs(value) < smallest_value * std::max(scale, std::abs(state_.trial_value))) return 0;
  return minimum > shortest_minimum && minimum < longest_minimum ? minimum : 0;
}

// Moves the trial along the step direction_, along which the gradient changes by target_, to the multiple `minimum` of
// it.
void Solver::move_trial(double minimum, double step_curvature) {
  if (std::abs(minimum - 1) <= near_enough || trial_is_stationary()) return;
  state_.trial_value = state_.value + minimum * dot(gradient_, direction_) + 0.5 * minimum * minimum * step_curvature;
  for (std::size_t j = 0; j < x_.size(); ++j) {
    trial_[j] = clip(x_[j] + minimum * direction_[j], set_.lower()[j], set_.upper()[j]);
    trial_gradient_[j] = gradient_[j] + minimum * target_[j];
  }
  if (minimum > 1) {
    set_.choose_face(trial_);
    set_.meet_rows(trial_);
  }
  state_.iterate = Iterate::interpolated;
}

// Whether the trial ends the run as it is. With rows, that takes a projection.
bool Solver::trial_is_stationary() const {
  if (!set_.box()) return false;
  double measure = 0;
  for (std::size_t j = 0; j < x_.size(); ++j) {
    const double moved = clip(trial_[j] - trial_gradient_[j], set_.lower()[j], set_.upper()[j]);
    measure = std::max(measure, std::abs(moved - trial_[j]));
  }
  return measure <= options_.gradient_tolerance;
}

// Requests f at an iterate that meets the tolerance by interpolated values.
Request Solver::verify() {
  std::copy(x_.begin(), x_.end(), trial_.begin());
  state_.iterate = Iterate::asked;
  return state_.ask(Phase::asked, options_.max_evaluations);
}

Request Solver::take_verification() {
  if (!std::isfinite(state_.trial_value)) {
    state_.iterate = Iterate::without_value;
    state_.quadratic = never;
    return begin_iteration();
  }
  state_.iterate = Iterate::evaluated;
  accept_trial();
  if (state_.phase == Phase::done) return Request::done;
  if (state_.measure > options_.gradient_tolerance) state_.quadratic = 0;  // by rounding, or f is not quadratic
  return begin_iteration();
}

}  // namespace orbicube::projected_gradient
