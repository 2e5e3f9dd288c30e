// The iteration of both methods. Method::dissertation is the dissertation's section 4.3.1: x + alpha d with
// d = P(x - g / lambda) - x (eq. 4.11), lambda = max(s'y / s's, 1e-10) (eq. 4.13) and a nonmonotone line search.
// Method::face takes d from the minimizer of a limited-memory model over the feasible set (face_step.h).
#include "projected_gradient/solver.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/infinity.h"
#include "base/names.h"
#include "projected_gradient/vector_math.h"

namespace orbicube::projected_gradient {

using base::require;
using base::Search;

namespace {

// No f that is bounded has such a value.
constexpr double bottomless = -1e200;

const Options& checked(const Options& options) {
  require(options.method == Method::face || options.method == Method::dissertation, "unknown method");
  require(options.line_search == LineSearch::max_of_last || options.line_search == LineSearch::average,
          "unknown line search");
  require(options.memory >= 1 && options.memory <= 1000, "memory must be from 1 to 1000 pairs");
  require(options.history >= 1 && options.history <= 1000000, "history must be from 1 to 1000000 values");
  require(options.average_weight >= 0 && options.average_weight <= 1, "average_weight must be from 0 to 1");
  require(options.gradient_tolerance >= 0, "gradient_tolerance must not be negative");
  require(!std::isnan(options.target), "target must be a number");
  return options;
}

// Few unknowns in a box: a matrix then costs at most twice the memory of the pairs.
bool takes_dense_model(const Problem& problem, const Options& options) {
  const bool box = problem.rows() == 0 && !problem.project;
  return options.method == Method::face && box && problem.n <= std::size_t{4} * options.memory;
}

std::size_t limited_pairs(const Problem& problem, const Options& options) {
  return options.method == Method::face && !takes_dense_model(problem, options) ? options.memory : 0;
}

// How far x + t d stays within the bounds.
double longest_step(std::span<const double> x, std::span<const double> d, std::span<const double> lower,
                    std::span<const double> upper) {
  double longest = base::infinity;
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (d[j] != 0) longest = std::min(longest, ((d[j] > 0 ? upper[j] : lower[j]) - x[j]) / d[j]);
  }
  return longest;
}

}  // namespace

const char* stop_name(Stop stop) {
  return base::name_of(
      stop, {"running", "converged", "target reached", "evaluation budget", "iteration budget", "stalled", "infeasible",
             "cancelled", "evaluation failed", "projection failed", "unbounded"});
}

Solver::Solver(const Problem& problem, const Options& options, std::span<const double> start, const base::Host& host)
    : host_(host),
      options_(checked(options)),
      set_(problem, host.memory),
      limited_(problem.n, problem.rows(), limited_pairs(problem, options), host.memory),
      dense_(takes_dense_model(problem, options) ? problem.n : 0, std::size_t{3} * options.memory, host.memory),
      face_step_(options.method == Method::face ? problem.n : 0, host.memory),
      x_(problem.n, 0.0, host.memory),
      gradient_(problem.n, 0.0, host.memory),
      trial_(problem.n, 0.0, host.memory),
      trial_gradient_(problem.n, 0.0, host.memory),
      target_(problem.n, 0.0, host.memory),
      direction_(problem.n, 0.0, host.memory),
      best_(problem.n, 0.0, host.memory),
      multipliers_(problem.rows(), 0.0, host.memory),
      last_values_(options.history, -base::infinity, host.memory) {
  require((start.size() == problem.n || start.empty()) && all_finite(start), "the start must be n finite numbers");
  for (const double x : start)
    require(std::abs(x) <= max_coordinate, "the start is beyond 1e150");
  std::copy(start.begin(), start.end(), x_.begin());
  std::copy(start.begin(), start.end(), best_.begin());
}

Request Solver::step() {
  return state_.step(host_, "projected gradient", options_.max_evaluations, [this] { return advance(); });
}

Request Solver::advance() {
  switch (state_.phase) {
    case Phase::created:
      if (!project(x_, trial_, 0)) return Request::done;
      std::copy(trial_.begin(), trial_.end(), best_.begin());
      return state_.ask(Phase::asked_first, options_.max_evaluations);
    case Phase::told_first:
      if (!std::isfinite(state_.trial_value)) return state_.finish(Stop::evaluation_failed);
      state_.curvature = std::max(max_magnitude(trial_gradient_), 1e-10);
      // From a start in a box the first step is to P(x - g), as far as a unit where g is smaller.
      model().set_sigma(set_.box() ? std::min(state_.curvature, 1.0) : state_.curvature);
      std::copy(trial_.begin(), trial_.end(), x_.begin());
      accept_trial();
      return state_.phase == Phase::done ? Request::done : Request::iteration;
    case Phase::iterate:
      return begin_iteration();
    case Phase::told:
      return take_trial();
    default:
      return Request::done;
  }
}

void Solver::tell(double value, std::span<const double> gradient) {
  require(state_.asked(), "nothing was requested");
  require(gradient.size() == x_.size(), "the gradient must have n entries");
  if (!std::isfinite(value) || !all_finite(gradient)) return tell_failure();
  std::copy(gradient.begin(), gradient.end(), trial_gradient_.begin());
  set_.subtract_rows(multipliers_, trial_gradient_);
  if (state_.tell(value)) std::copy(trial_.begin(), trial_.end(), best_.begin());
}

bool Solver::settle_projection(Projected outcome) {
  if (outcome == Projected::done) return true;
  state_.finish(outcome == Projected::infeasible ? Stop::infeasible : Stop::projection_failed);
  return false;
}

bool Solver::project(std::span<const double> y, std::span<double> x, double step) {
  return settle_projection(set_.project(y, x, step, host_));
}

// Makes the trial the iterate, with its projected gradient.
void Solver::accept_trial() {
  x_.swap(trial_);
  gradient_.swap(trial_gradient_);
  state_.value = state_.trial_value;
  last_values_[state_.iterations % last_values_.size()] = state_.value;
  if (state_.iterations == 0) {
    state_.average = state_.value;
    state_.average_count = 1;
  } else {
    const double count = options_.average_weight * state_.average_count + 1;
    state_.average = (options_.average_weight * state_.average_count * state_.average + state_.value) / count;
    state_.average_count = count;
  }
  for (std::size_t j = 0; j < x_.size(); ++j)
    trial_[j] = x_[j] - gradient_[j];
  state_.phase = Phase::iterate;
  if (!project(trial_, target_, 1)) return;
  double measure = 0;
  for (std::size_t j = 0; j < x_.size(); ++j)
    measure = std::max(measure, std::abs(target_[j] - x_[j]));
  const bool evaluated = state_.iterate == Iterate::evaluated;
  if (state_.settle(measure, evaluated)) std::copy(x_.begin(), x_.end(), best_.begin());
  // The rows' multipliers of this projection go into the gradient: it then tends to zero on the free unknowns, and
  // slopes along feasible directions do not drown in the rounding of g'd.
  const std::span<double> change = set_.guess();
  set_.subtract_rows(change, gradient_);
  for (std::size_t i = 0; i < multipliers_.size(); ++i)
    multipliers_[i] += change[i];
  std::fill(change.begin(), change.end(), 0.0);
  if (measure <= options_.gradient_tolerance) state_.unsettle(measure_in_large());
}

// The projected gradient without the rounding of x - g, where that may hide it: where x is large, and the gradient is
// larger than what the rounding of x alone makes of it. Else what is known already.
double Solver::measure_in_large() {
  constexpr double slack = 100, moved = 1e-6;
  const double largest = max_magnitude(x_), steepest = max_magnitude(gradient_);
  const double curvature = options_.method == Method::dissertation ? state_.curvature
                           : !model().empty()                      ? model().sigma()
                                                                   : 0.0;
  const double rounding = std::numeric_limits<double>::epsilon() * largest;
  if (!(steepest > std::max(options_.gradient_tolerance, slack * curvature * rounding)) ||
      !(steepest < slack * rounding))
    return state_.measure;
  double measure = state_.measure;
  if (set_.custom()) {
    // A step that the arithmetic resolves.
    const double factor = moved * largest / steepest;
    for (std::size_t j = 0; j < x_.size(); ++j)
      trial_[j] = x_[j] - factor * gradient_[j];
    if (!project(trial_, target_, factor)) return measure;
    for (std::size_t j = 0; j < x_.size(); ++j)
      measure = std::max(measure, std::abs(target_[j] - x_[j]) / factor);
  } else {
    for (std::size_t j = 0; j < x_.size(); ++j)
      measure = std::max(measure, std::abs(clip(-gradient_[j], set_.lower()[j] - x_[j], set_.upper()[j] - x_[j])));
  }
  return measure;
}

Request Solver::begin_iteration() {
  const Stop reason = state_.reason_to_end(options_);
  if (reason == Stop::converged && state_.iterate == Iterate::interpolated) return verify();
  if (reason != Stop::running && (reason != Stop::converged || state_.iterate == Iterate::evaluated))
    return state_.finish(reason);
  if (state_.best_value <= bottomless) return state_.finish(Stop::unbounded);
  const bool dissertation = options_.method == Method::dissertation;
  const bool found = dissertation ? choose_dissertation_direction() : choose_direction();
  if (state_.phase == Phase::done) return Request::done;
  if (!found) return state_.finish(Stop::stalled);
  return state_.ask(Phase::asked, options_.max_evaluations);
}

// d = P(x - g / lambda) - x, and the first trial at its end.
bool Solver::choose_dissertation_direction() {
  for (std::size_t j = 0; j < x_.size(); ++j)
    trial_[j] = x_[j] - gradient_[j] / state_.curvature;
  if (!project(trial_, target_, 1 / state_.curvature)) return false;
  for (std::size_t j = 0; j < x_.size(); ++j)
    direction_[j] = target_[j] - x_[j];
  const double slope = dot(gradient_, direction_);
  if (!(slope < 0)) return false;
  state_.backtracking.start(reference_value(), slope);
  std::copy(target_.begin(), target_.end(), trial_.begin());
  return true;
}

double Solver::reference_value() const {
  if (options_.line_search == LineSearch::average) return state_.average;
  return *std::max_element(last_values_.begin(), last_values_.end());
}

bool Solver::choose_direction() {
  for (;;) {
    state_.without_memory = model().empty();
    if (!settle_projection(face_step_.find(set_, model(), x_, gradient_, state_.measure, target_, host_))) return false;
    set_.choose_face(target_);
    set_.meet_rows(target_);
    for (std::size_t j = 0; j < x_.size(); ++j)
      direction_[j] = target_[j] - x_[j];
    const double slope = dot(gradient_, direction_);
    if (slope < 0) {
      start_search(slope);
      return true;
    }
    if (state_.without_memory) return false;
    model().clear();
  }
}

// Requests the end of direction_ first; in the first iteration in a box that is not bounded, for a point at most a unit
// away.
void Solver::start_search(double slope) {
  constexpr double max_rise = 0.9;
  const double longest = set_.custom() ? 1.0 : longest_step(x_, direction_, set_.lower(), set_.upper());
  state_.wolfe.start(state_.value, state_.best_value, slope, std::max(longest, 1.0));
  // Of few unknowns the model is good enough that flatter ends are worth a trial.
  if (dense_.size() > 0) state_.wolfe.max_rise = max_rise;
  std::copy(target_.begin(), target_.end(), trial_.begin());
  if (state_.iterations > 0 || !set_.box() || set_.bounded()) return;
  state_.wolfe.length = std::min(1.0, 1 / std::sqrt(dot(direction_, direction_)));
  follow_direction(state_.wolfe.length);
}

// trial = x + length direction, within the bounds.
void Solver::follow_direction(double length) {
  for (std::size_t j = 0; j < x_.size(); ++j)
    trial_[j] = clip(x_[j] + length * direction_[j], set_.lower()[j], set_.upper()[j]);
}

// Makes the trial the iterate, or the point at the multiple `minimum` of the step to it where that is positive.
Request Solver::take_step(double minimum) {
  ++state_.iterations;
  state_.iterate = Iterate::evaluated;
  // x and gradient become s and y, and then the new iterate takes their place.
  for (std::size_t j = 0; j < x_.size(); ++j) {
    direction_[j] = trial_[j] - x_[j];
    target_[j] = trial_gradient_[j] - gradient_[j];
  }
  const double step_curvature = dot(direction_, target_);
  if (options_.method == Method::dissertation) {
    // As printed, s'y <= 0 would make the next step 1e10: take the length of the first step again.
    state_.curvature = step_curvature > 0 ? std::max(step_curvature / dot(direction_, direction_), 1e-10)
                                          : std::max(max_magnitude(trial_gradient_), 1e-10);
  } else {
    if (minimum > 0) move_trial(minimum, step_curvature);
    // The curvature that sigma stands for is that of the face: y on bounds would make every step too short. In a
    // small face too little of y may be left; s'y / s's is the minimum that y'y / s'y can be. The old gradient is not
    // needed any more.
    std::copy(target_.begin(), target_.end(), gradient_.begin());
    if (!set_.custom()) {
      set_.choose_face(trial_);
      set_.project_to_face(gradient_);
    }
    const double in_face = dot(gradient_, gradient_) / step_curvature;
    const double sigma = std::max(in_face, step_curvature / dot(direction_, direction_));
    // Of a quadratic it changes half as fast: it would have to stay the same for conjugate directions in one face.
    const bool steady = minimum > 0 && !model().empty();
    model().push(direction_, target_, steady ? std::sqrt(model().sigma() * sigma) : sigma);
  }
  accept_trial();
  return state_.phase == Phase::done ? Request::done : Request::iteration;
}

Request Solver::take_trial() {
  if (state_.iterate == Iterate::asked) return take_verification();
  const bool dissertation = options_.method == Method::dissertation;
  Search verdict;
  double minimum = 0;
  if (dissertation) {
    verdict = state_.backtracking.advance(state_.value, state_.trial_value);
  } else {
    const double slope = std::isfinite(state_.trial_value) ? dot(trial_gradient_, direction_) : state_.trial_value;
    if (!set_.custom()) minimum = length_to_minimum(state_.wolfe.length, slope);
    verdict = minimum > 0 ? Search::accept : state_.wolfe.advance(state_.trial_value, slope);
  }
  if (verdict == Search::accept) return take_step(minimum);
  if (verdict == Search::again) {
    const double length = dissertation ? state_.backtracking.length : state_.wolfe.length;
    follow_direction(length);
    if (!dissertation && length > 1) {
      // What the iterate misses the rows by would be multiplied by every step beyond the target.
      set_.choose_face(trial_);
      set_.meet_rows(trial_);
    }
    return state_.ask(Phase::asked, options_.max_evaluations);
  }
  if (verdict == Search::endless) return state_.finish(Stop::unbounded);
  const bool failed = !std::isfinite(state_.trial_value);
  if (dissertation || state_.without_memory) return state_.finish(failed ? Stop::evaluation_failed : Stop::stalled);
  // The model may be at fault: again along the projected gradient.
  model().clear();
  model().set_sigma(std::max(max_magnitude(gradient_), 1e-10));
  return begin_iteration();
}

Result Solver::result() const {
  Result result;
  state_.describe(result);
  result.projected_gradient = state_.measure;
  if (state_.phase != Phase::created && state_.stop != Stop::infeasible) {
    result.equality_residual = set_.relative_residual(best_point());
  }
  result.projection_passes = set_.passes();
  result.certificate_gap = set_.certificate_gap();
  return result;
}

void Solver::copy_multipliers(std::span<double> out) const {
  for (std::size_t i = 0; i < multipliers_.size(); ++i)
    out[i] = multipliers_[i] * set_.linear_rows().scale(i);
}

std::span<const double> Solver::best_point() const {
  return state_.stop == Stop::converged ? x_ : best_;
}

}  // namespace orbicube::projected_gradient
