// Requests and returns; the method itself is in start.cpp and iteration.cpp.
#include "trust_region/solver.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/infinity.h"
#include "base/names.h"
#include "trust_region/dense.h"

namespace orbicube::trust_region {

using base::require;

namespace {

const Options& checked(const Options& options) {
  require(options.method == Method::two_radii || options.method == Method::dissertation, "unknown method");
  require(options.start >= Start::automatic && options.start <= Start::cross, "unknown start");
  require(options.radius_begin >= 0 && options.radius_begin <= 1e150, "radius_begin must be from 0 to 1e150");
  require(options.radius_end > 0 && options.radius_end <= 1e150, "radius_end must be positive, up to 1e150");
  require(options.radius_begin == 0 || options.radius_begin >= options.radius_end,
          "radius_begin must not be below radius_end");
  require(!std::isnan(options.target), "target must be a number");
  require(options.noise_absolute >= 0 && options.noise_relative >= 0 && std::isfinite(options.noise_absolute) &&
              std::isfinite(options.noise_relative),
          "noise must not be negative");
  return options;
}

// Up to this many unknowns the models of residuals are kept in both families.
constexpr std::size_t two_families_limit = 24;

// Maximum number interpolated, with enough evaluations.
std::size_t max_points(const Problem& problem, const Options& options, std::size_t free) {
  if (free == 0) return 1;
  const std::size_t full = (free + 1) * (free + 2) / 2;
  if (options.points != 0) {
    const std::size_t n = problem.n;
    require(options.points >= n + 2 && options.points <= (n + 1) * (n + 2) / 2,
            "points must be from n + 2 to (n + 1)(n + 2) / 2");
    return std::clamp<std::size_t>(options.points, free + 2, full);
  }
  if (options.method == Method::dissertation) return std::min(full, 2 * free + 1);
  // Sets grow to those of full quadratics while these are small.
  return std::min(
      full, problem.residuals > 0 ? std::max<std::size_t>(91, 2 * free + 1) : std::max<std::size_t>(45, 6 * free + 1));
}

// A scalar f with 2n + 1 points and no bounds does better with the memory alone, in the metric that it finds.
bool two_families(const Problem& problem, const Variables& variables, std::size_t capacity) {
  const std::size_t n = variables.free_size();
  return problem.residuals > 0 ? n <= two_families_limit : variables.bounded() || capacity > 2 * n + 1;
}

}  // namespace

const char* stop_name(Stop stop) {
  return base::name_of(stop, {"running", "converged", "target reached", "evaluation budget", "noise limit", "stalled",
                              "cancelled", "evaluation failed", "resolution limit"});
}

Solver::Solver(const Problem& problem, const Options& options, std::span<const double> start, const base::Host& host)
    : host_(host),
      options_(checked(options)),
      variables_(problem, start, options.radius_begin != 0, host.memory),
      max_points_(max_points(problem, options, variables_.free_size())),
      scale_given_(!problem.scale.empty()),
      interpolation_(variables_.free_size(), host.memory),
      models_(variables_.free_size(), problem.outputs(), problem.residuals > 0, problem.sign,
              two_families(problem, variables_, max_points_), host.memory, problem.objective),
      edges_(variables_.free_size(), host.memory),
      quadratic_step_(0, host.memory),
      best_(problem.n, 0.0, host.memory),
      best_outputs_(problem.outputs(), std::numeric_limits<double>::quiet_NaN(), host.memory),
      values_(host.memory),
      start_(variables_.free_size(), 0.0, host.memory),
      design_(host.memory),
      axes_(variables_.free_size(), 0, host.memory),
      requests_(host.memory),
      told_(problem.outputs(), 0.0, host.memory),
      error_(problem.outputs(), 0.0, host.memory),
      step_(variables_.free_size(), 0.0, host.memory),
      gradient_(variables_.free_size(), 0.0, host.memory),
      hessian_(host.memory),
      move_(variables_.free_size(), 0.0, host.memory),
      low_(variables_.free_size(), 0.0, host.memory),
      high_(variables_.free_size(), 0.0, host.memory),
      sharpest_(problem.objective != Objective::sum_of_squares ? variables_.free_size() : 0, 0.0, host.memory),
      candidate_(variables_.free_size(), 0.0, host.memory),
      squares_(host.memory),
      coefficients_(host.memory),
      basis_(host.memory),
      eigen_(0, host.memory) {
  require(start.size() == problem.n || start.empty(), "the start must have n entries");
  for (std::size_t i = 0; i < start.size(); ++i) {
    require(std::isfinite(start[i]), "the start must be finite");
    require(std::abs(start[i] / (problem.scale.empty() ? 1.0 : problem.scale[i])) <= 1e150,
            "the start over its scale is beyond 1e150");
    best_[i] = start[i];
  }
  variables_.to_free(best_, start_.data());
  double largest = 1;
  if (!variables_.scaled_by_boxes()) {
    for (std::size_t i = 0; i < start.size(); ++i)
      largest = std::max(largest, std::abs(start[i] / (problem.scale.empty() ? 1.0 : problem.scale[i])));
  }
  if (options_.max_evaluations == 0) options_.max_evaluations = 500 * (problem.n + 1);
  if (options_.radius_begin == 0) options_.radius_begin = std::max(0.1 * largest, options_.radius_end);
  cross_ = options_.start == Start::cross ||
           (options_.start == Start::automatic && !models_.of_residuals() && variables_.bounded());
  variables_.clip(start_.data());
  variables_.from_free(start_.data(), best_);
  state_.best_value = base::infinity;
  allocate(false);
}

// No model is made of fewer than n + 1 points, and no more points than evaluations come, but for those that are given.
void Solver::allocate(bool whole) {
  const std::size_t n = variables_.free_size();
  const bool modelled = whole || options_.max_evaluations > n;
  const auto within_budget = [&](std::size_t count) {
    return static_cast<std::size_t>(
        std::min<std::uint64_t>(count, std::max<std::uint64_t>(1, options_.max_evaluations)));
  };
  const std::size_t capacity =
      whole ? max_points_ : std::max(within_budget(max_points_), modelled ? std::min(n + 2, max_points_) : 1);
  whole_ = whole ? 1 : 0;
  interpolation_.allocate(capacity, modelled);
  models_.allocate(capacity, modelled);
  values_.resize(capacity);
  squares_.resize(capacity);
  const std::size_t rows = cross_ ? within_budget(2 * n + 1) : 1;
  design_.resize(rows * n);
  requests_.resize(rows * size());
  if (!modelled) return;
  edges_.allocate(capacity);
  quadratic_step_ = QuadraticStep(n, host_.memory);
  coefficients_.resize(n + capacity);
  hessian_.resize(n * n);
  basis_.resize(n * n);
  variables_.allow_turns();
  if (!variables_.bounded() && n <= Variables::max_turned) eigen_ = Tridiagonal(n, host_.memory);
}

void Solver::give(std::span<const double> x, std::span<const double> outputs) {
  require(state_.phase == Phase::created, "evaluations are given before the first step");
  require(x.size() == size() && outputs.size() == this->outputs(), "x has n entries, and outputs one a residual");
  require(variables_.within_bounds(x), "a given point is not within the bounds");
  const double value = models_.objective(outputs.data());
  require(std::isfinite(value), "a given value is not finite");
  if (whole_ == 0) allocate(true);
  if (value < state_.best_value) {
    state_.best_value = value;
    std::copy(x.begin(), x.end(), best_.begin());
    std::copy(outputs.begin(), outputs.end(), best_outputs_.begin());
  }
  std::size_t j = interpolation_.size();
  if (j == interpolation_.capacity()) {
    // The highest goes.
    j = static_cast<std::size_t>(std::max_element(values_.begin(), values_.end()) - values_.begin());
    if (values_[j] <= value) return;
  } else {
    interpolation_.resize(j + 1);
  }
  variables_.to_free(x, candidate_.data());
  variables_.clip(candidate_.data());
  interpolation_.place(j, candidate_.data());
  models_.store(j, outputs.data());
  values_[j] = value;
}

Request Solver::step() {
  if (asked()) return Request::need_values;
  try {
    host_.report("trust region", state_.evaluations, options_.max_evaluations, state_.best_value);
    return advance();
  } catch (const base::Error& error) {
    if (error.status() != base::Status::cancelled) throw;
    state_.cancelled_by_host = 1;
    return finish(Stop::cancelled);
  }
}

Request Solver::advance() {
  switch (state_.phase) {
    case Phase::created:
      return begin();
    case Phase::start_told:
      return next_of_start();
    case Phase::iterate:
      return iterate();
    case Phase::trial_told:
      ++state_.iterations;
      take_trial();
      return state_.phase == Phase::iterate ? Request::iteration : iterate();
    case Phase::geometry_told:
      take_geometry();
      return iterate();
    default:
      return Request::done;
  }
}

// At the points in design_ from design_next on.
Request Solver::ask(Phase phase) {
  if (state_.evaluations >= options_.max_evaluations) return finish(Stop::evaluation_budget);
  state_.design_end = std::min(state_.design_end, state_.design_next + options_.max_evaluations - state_.evaluations);
  state_.phase = phase;
  return Request::need_values;
}

Request Solver::finish(Stop stop) {
  state_.phase = Phase::done;
  state_.stop = stop;
  return Request::done;
}

void Solver::put_request(std::size_t row, const double* u) {
  std::copy_n(u, variables_.free_size(), design_.data() + row * variables_.free_size());
  variables_.from_free(u, std::span(requests_).subspan(row * size(), size()));
}

std::span<const double> Solver::pending() const {
  return std::span(requests_).subspan(state_.design_next * size(), pending_count() * size());
}

void Solver::tell(std::span<const double> outputs) {
  require(asked(), "nothing was requested");
  require(outputs.size() == this->outputs(), "there must be one number a residual");
  ++state_.evaluations;
  std::copy(outputs.begin(), outputs.end(), told_.begin());
  state_.told_value = models_.objective(told_.data());
  // A signed sum may be finite by chance where a residual is not.
  for (const double value : told_) {
    if (!std::isfinite(value)) state_.told_value = base::infinity;
  }
  const bool failed = !std::isfinite(state_.told_value);
  if (failed || beyond_cliff(state_.told_value)) {
    state_.told_value = base::infinity;
    state_.failed_evaluations += failed ? 1 : 0;
    ++state_.failures_in_row;
    ++state_.failures_of_level;
    if (follows_edges()) edges_.add(design_.data() + state_.design_next * variables_.free_size());
  } else {
    state_.failures_in_row = 0;
    if (!std::isfinite(state_.first_value)) state_.first_value = state_.told_value;
    if (state_.told_value < state_.best_value) {
      state_.best_value = state_.told_value;
      std::copy_n(requests_.data() + state_.design_next * size(), size(), best_.begin());
      std::copy(told_.begin(), told_.end(), best_outputs_.begin());
    }
  }
  if (state_.phase == Phase::start) {
    take_start();
  } else {
    state_.phase = state_.phase == Phase::trial ? Phase::trial_told : Phase::geometry_told;
  }
}

void Solver::tell_failure() {
  std::fill(error_.begin(), error_.end(), std::numeric_limits<double>::quiet_NaN());
  tell(error_);
}

double Solver::noise() const {
  return std::max(options_.noise_absolute, options_.noise_relative * std::abs(state_.best_value));
}

// Whether a value is a number beyond an edge of the domain all the same, as of a penalty: quadratics would only be
// spoiled by it. It is out of all proportion to the values around, and does not fall when steps get shorter.
bool Solver::beyond_cliff(double value) {
  // In units of what the points around differ by, and of how far f has fallen since the start.
  constexpr double rise = 1e3, beyond_start = 10;
  // A rise that is linear in the length of the step would be `shorter` as high.
  constexpr double still = 0.7, shorter = 0.55;
  if (!follows_edges() || interpolation_.size() < 2) return false;
  const double above = value - state_.best_value, fallen = state_.first_value - state_.best_value;
  if (!(above > std::max(std::abs(state_.best_value), beyond_start * fallen))) return false;
  const std::size_t n = variables_.free_size();
  double square = 0, most = 0;
  squared_distances(design_.data() + state_.design_next * n, n, 1, interpolation_.point(interpolation_.best()),
                    &square);
  const double length = std::sqrt(square);
  for (std::size_t j = 0; j < interpolation_.size(); ++j)
    most = std::max(most, values_[j] - state_.best_value);
  const bool as_high = state_.cliff_height > 0 && above >= still * state_.cliff_height;
  if (state_.cliffs > 0) return as_high || above > rise * most;
  if (as_high && length <= shorter * state_.cliff_length) {
    state_.cliffs = 1;
    return true;
  }
  if (above > rise * most) {
    state_.cliff_height = above;
    state_.cliff_length = length;
  }
  return false;
}

// What was taken for values before they were known to be beyond an edge.
void Solver::forget_cliffs() {
  if (state_.cliffs != 1) return;
  state_.cliffs = 2;
  state_.spoiled = 1;
  models_.forget();
  for (std::size_t j = interpolation_.size(); j-- > 0;) {
    if (j == interpolation_.best() || !(values_[j] - state_.best_value >= 0.5 * state_.cliff_height)) continue;
    edges_.add(interpolation_.point(j));
    forget_point(j);
  }
}

Result Solver::result() const {
  Result result;
  result.stop = state_.stop;
  if (std::isfinite(state_.best_value)) result.value = state_.best_value;
  result.radius = state_.radius;
  result.resolution = state_.resolution;
  result.evaluations = state_.evaluations;
  result.failed_evaluations = state_.failed_evaluations;
  result.iterations = state_.iterations;
  result.restarts = state_.restarts;
  result.points = interpolation_.size();
  result.rebuilds = interpolation_.rebuilds();
  return result;
}

}  // namespace orbicube::trust_region
