// The iterations. All methods move every block along the great circle in the direction of its part of a tangent vector.
//
// limited_memory: L-BFGS with parallel transport and a Wolfe search along the arcs. barzilai_borwein: Iannazzo and
// Porcelli 2018, "The Riemannian Barzilai-Borwein method with nonmonotone line search". great_circle: the
// dissertation's Algorithm 2 along the tangent gradient, the first angle from the last search, halved until the value
// falls. dissertation: Algorithm 2 as printed, all blocks turning and halving together. truncated_newton has a file of
// its own.
#include "sphere_optimizer/solver.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/error.h"
#include "base/infinity.h"
#include "base/names.h"
#include "base/sums.h"
#include "sphere_optimizer/great_circle.h"
#include "sphere_optimizer/spheres.h"

namespace orbicube::sphere_optimizer {

using base::require;
using base::Search;

namespace {

constexpr double quarter_circle = 0.5 * std::numbers::pi;

const Options& checked(const Options& options) {
  require(options.method >= Method::limited_memory && options.method <= Method::truncated_newton, "unknown method");
  require(options.memory >= 1 && options.memory <= 1000, "memory must be from 1 to 1000 pairs");
  require(options.history >= 1 && options.history <= 1000000, "history must be from 1 to 1000000 values");
  require(options.hessian_products <= 1, "hessian_products must be 0 or 1");
  require(options.gradient_tolerance >= 0, "gradient_tolerance must not be negative");
  require(!std::isnan(options.target), "target must be a number");
  require(options.starts >= 1, "there must be a start");
  return options;
}

const Shape& checked(const Shape& shape) {
  require(shape.count >= 1, "there must be a sphere");
  require(shape.dimension >= 2, "spheres must be in at least two dimensions");
  constexpr auto most = static_cast<std::size_t>(std::min<std::uint64_t>(1ULL << 40U, PTRDIFF_MAX / sizeof(double)));
  require(shape.count < most / shape.dimension, "there are too many unknowns");
  return shape;
}

}  // namespace

const char* stop_name(Stop stop) {
  return base::name_of(stop, {"running", "converged", "target reached", "evaluation budget", "iteration budget",
                              "stalled", "cancelled", "evaluation failed"});
}

Solver::Solver(const Shape& shape, const Options& options, std::span<const double> start, const base::Host& host)
    : host_(host),
      shape_(checked(shape)),
      options_(checked(options)),
      memory_(shape, options.method == Method::limited_memory ? options.memory : 0, host.memory),
      newton_step_(shape, options.method == Method::truncated_newton, host.memory),
      x_(shape.size(), 0.0, host.memory),
      gradient_(shape.size(), 0.0, host.memory),
      trial_(shape.size(), 0.0, host.memory),
      trial_gradient_(shape.size(), 0.0, host.memory),
      direction_(shape.size(), 0.0, host.memory),
      velocity_(shape.size(), 0.0, host.memory),
      best_(shape.size(), 0.0, host.memory),
      lowest_point_(options.starts > 1 ? shape.size() : 0, 0.0, host.memory),
      radial_(shape.count, 0.0, host.memory),
      trial_radial_(shape.count, 0.0, host.memory),
      curvature_(shape.count, 1.0, host.memory),
      ambient_(options.method == Method::dissertation ? shape.size() : 0, 0.0, host.memory),
      trial_ambient_(options.method == Method::dissertation ? shape.size() : 0, 0.0, host.memory),
      last_values_(options.method == Method::barzilai_borwein ? options.history : 0, -base::infinity, host.memory) {
  if (start.empty()) return;
  require(start.size() == shape.size() && base::all_finite(start), "the start must be finite numbers");
  std::copy(start.begin(), start.end(), x_.begin());
  with_dimension(shape.dimension, [&](auto d) {
    for (std::size_t i = 0; i < shape_.count; ++i)
      require(normalize(d, &x_[i * d]), "a block of the start is zero or far from length 1");
  });
  std::copy(x_.begin(), x_.end(), best_.begin());
}

Request Solver::step() {
  return state_.step(host_, phase_name, options_.max_evaluations, [this] { return advance(); });
}

Request Solver::advance() {
  switch (state_.phase) {
    case Phase::created:
      std::copy(x_.begin(), x_.end(), trial_.begin());
      return state_.ask(Phase::asked_first, options_.max_evaluations);
    case Phase::told_first:
      if (!std::isfinite(state_.trial_value)) return end_start(Stop::evaluation_failed);
      begin_at_trial();
      return Request::iteration;
    case Phase::iterate:
      return begin_iteration();
    case Phase::told:
      return take_trial();
    case Phase::told_product:
      return take_product();
    default:
      return Request::done;
  }
}

void Solver::tell(double value, std::span<const double> gradient) {
  require(state_.asked(), "nothing was requested");
  require(gradient.size() == shape_.size(), "the gradient must have as many entries as the point");
  if (!std::isfinite(value) || !base::all_finite(gradient)) return tell_failure();
  if (gradient.data() != trial_gradient_.data()) std::copy(gradient.begin(), gradient.end(), trial_gradient_.begin());
  if (!trial_ambient_.empty()) std::copy(gradient.begin(), gradient.end(), trial_ambient_.begin());
  with_dimension(shape_.dimension, [&](auto d) {
    for (std::size_t i = 0; i < shape_.count; ++i)
      trial_radial_[i] = make_tangent(d, &trial_[i * d], &trial_gradient_[i * d]);
  });
  if (state_.tell(value)) std::copy(trial_.begin(), trial_.end(), best_.begin());
}

// Length of the longest block.
double Solver::longest_block(std::span<const double> v) const {
  double longest = 0;
  with_dimension(shape_.dimension, [&](auto d) {
    for (std::size_t i = 0; i < shape_.count; ++i)
      longest = std::max(longest, block_dot(d, &v[i * d], &v[i * d]));
  });
  return std::sqrt(longest);
}

// Makes the trial the iterate.
void Solver::begin_at_trial() {
  x_.swap(trial_);
  gradient_.swap(trial_gradient_);
  radial_.swap(trial_radial_);
  ambient_.swap(trial_ambient_);
  state_.value = state_.trial_value;
  if (!last_values_.empty()) last_values_[state_.iterations % last_values_.size()] = state_.value;
  if (state_.settle(longest_block(gradient_))) std::copy(x_.begin(), x_.end(), best_.begin());
  state_.phase = Phase::iterate;
}

Request Solver::begin_iteration() {
  const Stop reason = state_.reason_to_end(options_);
  if (reason != Stop::running) return end_start(reason);
  if (options_.method == Method::truncated_newton) return begin_newton_step();
  if (!choose_direction()) return end_start(Stop::stalled);
  place_trial(trial_length());
  return state_.ask(Phase::asked, options_.max_evaluations);
}

// The direction and the start of its search; false when there is none that descends.
bool Solver::choose_direction() {
  constexpr double first_angle = 0.1;  // of the block with the longest gradient, while nothing is known
  constexpr double max_angle = 1;      // of a direction of limited_memory, before its search
  if (options_.method == Method::dissertation) {
    choose_printed_direction();
    return state_.backtracking.start_slope < 0;
  }
  state_.without_memory = memory_.count() == 0;
  const auto follow_gradient = [&](double factor) {
    for (std::size_t j = 0; j < direction_.size(); ++j)
      direction_[j] = -factor * gradient_[j];
  };
  switch (options_.method) {
    case Method::limited_memory:
      if (!state_.without_memory) {
        estimate_curvature();
        memory_.descend(gradient_, curvature_, direction_, [this] { report(); });
        if (base::dot(gradient_, direction_) < 0) break;
        memory_.clear();
        state_.without_memory = 1;
      }
      follow_gradient(first_angle / state_.measure);
      break;
    case Method::barzilai_borwein: {
      const double longest = quarter_circle / state_.measure;
      follow_gradient(state_.step_length == 0 ? first_angle / state_.measure : std::min(state_.step_length, longest));
      break;
    }
    default:
      follow_gradient(std::min(quarter_circle, 2 * state_.arc) / state_.measure);
  }
  double angle = longest_block(direction_);
  if (options_.method == Method::limited_memory && angle > max_angle) {
    for (double& value : direction_)
      value *= max_angle / angle;
    angle = max_angle;
  }
  const double slope = base::dot(gradient_, direction_);
  if (!(slope < 0)) return false;
  if (options_.method == Method::limited_memory) {
    state_.wolfe.start(state_.value, state_.best_value, slope, quarter_circle / angle);
    state_.wolfe.level = std::max(state_.wolfe.level, state_.best_value + cancelled_part());
  } else {
    const bool nonmonotone = options_.method == Method::barzilai_borwein;
    state_.backtracking.start(nonmonotone ? *std::max_element(last_values_.begin(), last_values_.end()) : state_.value,
                              slope);
  }
  return true;
}

// On the sphere the Hessian of block i is P (H - (G.x) I) P. Of it -G.x is known, the whole of it where f is bilinear
// in its blocks, as sums over neighbors often are; where it is positive it says which blocks are stiff.
void Solver::estimate_curvature() {
  constexpr double range = 10;
  const double mean = -base::blocked_sum(radial_.size(), [&](std::size_t i) { return radial_[i]; }) /
                      static_cast<double>(radial_.size());
  for (std::size_t i = 0; i < radial_.size(); ++i)
    curvature_[i] = mean > 0 ? std::clamp(-radial_[i] / mean, 1 / range, range) : 1.0;
}

// What rounding may add to a value whose terms cancel: they are about as large as the radial parts of the gradient.
double Solver::cancelled_part() const {
  constexpr double rounding = 0x1p-52;
  return rounding * base::blocked_sum(radial_.size(), [&](std::size_t i) { return std::abs(radial_[i]); });
}

// Algorithm 2 as printed, for every block at once. A block whose violation of the first-order condition is within the
// tolerance stays.
void Solver::choose_printed_direction() {
  for_each_block([&](auto d, std::size_t i) {
    const double* tangent = &gradient_[i * d];
    const double violation = std::sqrt(block_dot(d, tangent, tangent));
    const bool moves = violation > options_.gradient_tolerance;
    const double angle = moves ? printed_angle(d, &x_[i * d], &ambient_[i * d]) : 0.0;
    for (std::size_t k = 0; k < d; ++k)
      direction_[i * d + k] = moves ? -angle / violation * tangent[k] : 0.0;
  });
  state_.backtracking.start(state_.value, base::dot(gradient_, direction_));
}

double Solver::trial_length() const {
  return options_.method == Method::limited_memory ? state_.wolfe.length : state_.backtracking.length;
}

// trial_ and velocity_, the direction carried there.
void Solver::place_trial(double length) {
  for_each_block([&](auto d, std::size_t i) {
    move(d, &x_[i * d], &direction_[i * d], length, &trial_[i * d], &velocity_[i * d]);
  });
}

// What the condition of Algorithm 2 compares with: the product of the chord from the iterate to the trial and the whole
// gradient.
double Solver::chord_slope() const {
  return base::blocked_sum(x_.size(), [&](std::size_t j) { return (trial_[j] - x_[j]) * ambient_[j]; });
}

Search Solver::judge_trial() {
  constexpr double decrease = 1e-4;
  constexpr std::uint64_t halving_limit = 60;
  base::BacktrackingSearch& search = state_.backtracking;
  switch (options_.method) {
    case Method::limited_memory: {
      base::WolfeSearch& wolfe = state_.wolfe;
      const bool finite = std::isfinite(state_.trial_value);
      const double slope = finite ? base::dot(trial_gradient_, velocity_) : state_.trial_value;
      // The first step only has to tell the scale of the curvature, for which it need not be long.
      const bool first = state_.without_memory && wolfe.trials == 0 && slope > wolfe.start_slope;
      if (first && state_.trial_value <= wolfe.start_value + decrease * wolfe.length * wolfe.start_slope) {
        return Search::accept;
      }
      return wolfe.advance(state_.trial_value, slope);
    }
    case Method::barzilai_borwein:
      return search.advance(state_.value, state_.trial_value);
    default: {
      const double slope = options_.method == Method::dissertation ? chord_slope() : search.length * search.start_slope;
      if (state_.trial_value <= search.reference + decrease * slope) return Search::accept;
      search.length *= 0.5;
      return ++search.trials >= halving_limit ? Search::give_up : Search::again;
    }
  }
}

void Solver::accept_trial() {
  const double length = trial_length();
  ++state_.iterations;
  state_.arc = length * longest_block(direction_);
  if (options_.method == Method::limited_memory || options_.method == Method::barzilai_borwein) {
    // velocity_ and gradient_ become step and change of the gradient, both at the trial.
    for_each_block([&](auto d, std::size_t i) {
      transport(d, &x_[i * d], &trial_[i * d], &gradient_[i * d]);
      for (std::size_t k = i * d; k < (i + 1) * d; ++k) {
        gradient_[k] = trial_gradient_[k] - gradient_[k];
        velocity_[k] *= length;
      }
    });
    if (options_.method == Method::limited_memory) {
      memory_.transport(x_, trial_, [this] { report(); });
      memory_.push(velocity_, gradient_);
    } else {
      // The long and the short step by turns; where there is no curvature, as far as can be.
      const double product = base::dot(velocity_, gradient_);
      const bool take_long = state_.iterations % 2 == 0;
      state_.step_length =
          take_long ? base::dot(velocity_, velocity_) / product : product / base::dot(gradient_, gradient_);
      if (!(product > 0 && state_.step_length > 0)) state_.step_length = base::infinity;
    }
  }
  begin_at_trial();
}

Request Solver::take_trial() {
  if (options_.method == Method::truncated_newton) {
    return state_.newton.difference > 0 ? take_difference() : take_newton_step();
  }
  switch (judge_trial()) {
    case Search::accept:
      accept_trial();
      return Request::iteration;
    case Search::again:
      place_trial(trial_length());
      return state_.ask(Phase::asked, options_.max_evaluations);
    default:
      break;
  }
  const bool failed = !std::isfinite(state_.trial_value);
  if (options_.method != Method::limited_memory || state_.without_memory) {
    return end_start(failed ? Stop::evaluation_failed : Stop::stalled);
  }
  // The memory may be at fault: again along the gradient.
  memory_.clear();
  return begin_iteration();
}

}  // namespace orbicube::sphere_optimizer
