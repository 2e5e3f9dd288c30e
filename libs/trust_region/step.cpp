// The step of the models within the trust region, the box, and the planes that keep it off edges of f.
#include <algorithm>
#include <cmath>
#include <limits>

#include "trust_region/dense.h"
#include "trust_region/solver.h"

namespace orbicube::trust_region {
namespace {

// How hard the planes of edges are, in units of the model's curvature.
constexpr double stiffness = 1e4;
// The inner iteration ends when it gains less than this part of the predicted change: with many unknowns sooner, since
// each of its steps costs about m n^2 operations, and models are good to more digits only where there are enough
// points.
constexpr double gain_of_few = 1e-6, gain_of_many = 1e-3;
constexpr std::size_t many_unknowns = 24;
// Corners are rounded by this part of what residuals may change by in the trust region, then by a tenth of it and so
// on, until that is less than a part of the change of f that is predicted, or lost in rounding.
constexpr double first_width = 0.1, fall_of_width = 0.1, precise_corners = 1e-3, least_width = 1e-9;
constexpr double tiniest_width = 1e-150;  // where the models are constant
// Gain of the inner iteration for one of these widths.
constexpr double gain_of_corners = 1e-3;

}  // namespace

// The box as seen from the best point + d.
void Solver::relative_bounds(const double* d) {
  const double* best = interpolation_.point(interpolation_.best());
  for (std::size_t i = 0; i < low_.size(); ++i) {
    const double at = best[i] + (d != nullptr ? d[i] : 0.0);
    low_[i] = std::min(0.0, variables_.lower()[i] - at);
    high_[i] = std::max(0.0, variables_.upper()[i] - at);
  }
}

// Computes a step into d; returns the change of f that the models predict.
double Solver::choose_step(double* d) {
  const std::size_t n = variables_.free_size(), best = interpolation_.best();
  const double* low = variables_.bounded() ? low_.data() : nullptr;
  const double* high = variables_.bounded() ? high_.data() : nullptr;
  std::fill_n(d, n, 0.0);
  if (models_.has_corners())
    models_.corners().set_width(std::max(first_width * models_.reach(state_.radius), tiniest_width));
  models_.expand(d, best, gradient_.data(), hessian_.data());
  relative_bounds(nullptr);
  quadratic_step_.minimise(gradient_.data(), hessian_.data(), state_.radius, low, high, d);
  edges_.find(interpolation_, reach_of_edges * state_.radius);
  const bool confined = edges_.count() > 0;
  if (confined) {
    edge_weight_ = stiffness * (norm(gradient_.data(), n) / state_.radius + max_magnitude(hessian_.data(), n * n));
    edges_.confine(d);
  }
  double value = change_of(d);
  if (!models_.of_residuals() && !confined) return value;
  for (int halving = 0; halving < 10 && !(value < 0); ++halving) {
    for (std::size_t i = 0; i < n; ++i)
      d[i] *= 0.5;
    value = change_of(d);
  }
  refine_step(d, &value);
  if (models_.has_corners()) value = sharpen_step(d);
  if (!confined) return value;
  edges_.confine(d);
  if (low != nullptr) {
    for (std::size_t i = 0; i < n; ++i)
      d[i] = std::clamp(d[i], low_[i], high_[i]);
  }
  return models_.change(d, best);
}

// From the step for rounded corners to that for f itself; returns its change of f.
double Solver::sharpen_step(double* d) {
  const std::size_t n = variables_.free_size();
  Corners& corners = models_.corners();
  const double least =
      std::max(least_width * corners.width(), std::numeric_limits<double>::epsilon() * std::abs(state_.best_value));
  double lowest = std::numeric_limits<double>::infinity();
  for (double width = corners.width();; width *= fall_of_width) {
    corners.set_width(0);
    if (const double value = change_of(d); value < lowest) {
      lowest = value;
      std::copy_n(d, n, sharpest_.data());
    }
    corners.set_width(width);
    if (corners.error(models_.outputs()) <= precise_corners * -lowest || !(width > least)) break;
    corners.set_width(fall_of_width * width);
    double value = change_of(d);
    refine_step(d, &value);
  }
  corners.set_width(0);
  std::copy_n(sharpest_.data(), n, d);
  return lowest;
}

// The models' change of f, and a penalty for what is beyond the planes of edges_.
double Solver::change_of(const double* d) {
  double value = models_.change(d, interpolation_.best());
  for (std::size_t k = 0; k < edges_.count(); ++k) {
    const double beyond = dot(edges_.normal(k), d, variables_.free_size()) - edges_.room(k);
    if (beyond > 0) value += 0.5 * edge_weight_ * beyond * beyond;
  }
  return value;
}

// Its gradient and Hessian.
void Solver::expand_at(const double* d) {
  const std::size_t n = variables_.free_size();
  models_.expand(d, interpolation_.best(), gradient_.data(), hessian_.data());
  for (std::size_t k = 0; k < edges_.count(); ++k) {
    const double* normal = edges_.normal(k);
    const double beyond = dot(normal, d, n) - edges_.room(k);
    if (!(beyond > 0)) continue;
    add_scaled(gradient_.data(), edge_weight_ * beyond, normal, n);
    for (std::size_t i = 0; i < n; ++i)
      add_scaled(hessian_.data() + i * n, edge_weight_ * normal[i], normal, n);
  }
}

// The sum of squared quadratics is a quartic, and the penalty of edges is not smooth: a trust-region iteration of its
// own, which costs no evaluation.
void Solver::refine_step(double* d, double* value) {
  const std::size_t n = variables_.free_size();
  double inner = std::max(0.5 * norm(d, n), 1e-3 * state_.radius);
  double* trial = candidate_.data();
  const double least_gain = models_.has_corners() ? gain_of_corners : n > many_unknowns ? gain_of_many : gain_of_few;
  bool known = false;  // gradient_ and hessian_ are those at d
  for (int iteration = 0; iteration < 30; ++iteration) {
    host_.report("trust region", state_.evaluations, options_.max_evaluations, state_.best_value);
    if (!known) expand_at(d);
    known = true;
    const double moved = move_within(d, inner, trial);
    const double next = change_of(trial);
    if (next < *value) {
      const double gain = *value - next;
      std::copy_n(trial, n, d);
      *value = next;
      known = false;
      inner = std::min(2 * inner, 2 * state_.radius);
      if (gain < least_gain * std::abs(*value) || moved < 1e-8 * state_.radius) break;
    } else {
      inner *= 0.25;
      if (inner < 1e-4 * state_.radius) break;
    }
  }
  relative_bounds(nullptr);
}

// Puts into `trial` where the quadratic at d, in gradient_ and hessian_, leads within `inner` around d; returns how far
// from d. Where that is beyond the ball, the minimizer within the ball is the aim, so that steps along its boundary
// converge as Newton's method does.
double Solver::move_within(const double* d, double inner, double* trial) {
  const std::size_t n = variables_.free_size();
  const double* low = variables_.bounded() ? low_.data() : nullptr;
  const double* high = variables_.bounded() ? high_.data() : nullptr;
  relative_bounds(d);
  quadratic_step_.minimise(gradient_.data(), hessian_.data(), inner, low, high, move_.data());
  for (std::size_t i = 0; i < n; ++i)
    trial[i] = d[i] + move_[i];
  const double length = norm(trial, n);
  if (!(length > state_.radius)) return norm(move_.data(), n);
  if (edges_.count() > 0) {
    // The penalty of edges has kinks, so that nothing is gained by following the boundary.
    double square = 0;
    for (std::size_t i = 0; i < n; ++i) {
      trial[i] *= state_.radius / length;
      square += (trial[i] - d[i]) * (trial[i] - d[i]);
    }
    return std::sqrt(square);
  }
  // The gradient at the best point.
  for (std::size_t i = 0; i < n; ++i)
    move_[i] = gradient_[i] - dot(hessian_.data() + i * n, d, n);
  relative_bounds(nullptr);
  quadratic_step_.minimise(move_.data(), hessian_.data(), state_.radius, low, high, trial);
  for (std::size_t i = 0; i < n; ++i)
    move_[i] = trial[i] - d[i];
  const double far = norm(move_.data(), n);
  if (!(far > inner)) return far;
  for (std::size_t i = 0; i < n; ++i)
    trial[i] = d[i] + inner / far * move_[i];
  return inner;
}

}  // namespace orbicube::trust_region
