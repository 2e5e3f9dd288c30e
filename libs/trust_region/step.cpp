// The step of the models within the trust region, the box, and the planes that keep it off edges of f.
#include <algorithm>
#include <cmath>

#include "trust_region/dense.h"
#include "trust_region/solver.h"

namespace orbicube::trust_region {
namespace {

// How hard the planes of edges are, in units of the model's curvature.
constexpr double stiffness = 1e4;

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
  if (!models_.least_squares() && !confined) return value;
  for (int halving = 0; halving < 10 && !(value < 0); ++halving) {
    for (std::size_t i = 0; i < n; ++i)
      d[i] *= 0.5;
    value = change_of(d);
  }
  refine_step(d, &value);
  if (!confined) return value;
  edges_.confine(d);
  if (low != nullptr) {
    for (std::size_t i = 0; i < n; ++i)
      d[i] = std::clamp(d[i], low_[i], high_[i]);
  }
  return models_.change(d, best);
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
  const double* low = variables_.bounded() ? low_.data() : nullptr;
  const double* high = variables_.bounded() ? high_.data() : nullptr;
  double inner = std::max(0.5 * norm(d, n), 1e-3 * state_.radius);
  double* trial = candidate_.data();
  for (int iteration = 0; iteration < 30; ++iteration) {
    host_.report("trust region", state_.evaluations, options_.max_evaluations, state_.best_value);
    expand_at(d);
    relative_bounds(d);
    quadratic_step_.minimise(gradient_.data(), hessian_.data(), inner, low, high, move_.data());
    double square = 0;
    for (std::size_t i = 0; i < n; ++i) {
      trial[i] = d[i] + move_[i];
      square += trial[i] * trial[i];
    }
    const double shrink = square > state_.radius * state_.radius ? state_.radius / std::sqrt(square) : 1;
    double moved = 0;
    for (std::size_t i = 0; i < n; ++i) {
      trial[i] *= shrink;
      moved += (trial[i] - d[i]) * (trial[i] - d[i]);
    }
    const double next = change_of(trial);
    if (next < *value) {
      const double gain = *value - next;
      std::copy_n(trial, n, d);
      *value = next;
      inner = std::min(2 * inner, 2 * state_.radius);
      if (gain < 1e-6 * std::abs(*value) || moved < 1e-16 * state_.radius * state_.radius) break;
    } else {
      inner *= 0.25;
      if (inner < 1e-4 * state_.radius) break;
    }
  }
  relative_bounds(nullptr);
}

}  // namespace orbicube::trust_region
