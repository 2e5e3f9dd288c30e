// The iterations of truncated_newton: a trust region (Absil, Baker, Gallivan 2007, "Trust-region methods on Riemannian
// manifolds"), with products of the Hessian that the caller supplies or that are differences of transported gradients.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "base/sums.h"
#include "sphere_optimizer/solver.h"
#include "sphere_optimizer/spheres.h"

namespace orbicube::sphere_optimizer {

using base::Request;
using base::require;

Request Solver::begin_newton_step() {
  constexpr std::uint64_t patience = 20;  // steps without gain
  constexpr double least_accuracy = 0.1;  // of the first steps; later ones are as accurate as the gradient is short
  constexpr double first_radius = 0.125 * std::numbers::pi;  // an angle a block
  if (state_.without_gain >= patience) return end_start(Stop::stalled);
  Newton& newton = state_.newton;
  const double length = std::sqrt(base::dot(gradient_, gradient_));
  if (newton.radius == 0) {
    newton.radius = first_radius * std::sqrt(static_cast<double>(shape_.count));
    newton.first_gradient = length;
  }
  estimate_curvature();
  newton_step_.begin(gradient_, curvature_, newton.radius,
                     std::clamp(std::sqrt(length / newton.first_gradient), 0.01, least_accuracy));
  return ask_product();
}

Request Solver::ask_product() {
  constexpr double difference_angle = 0x1p-23;  // between rounding of gradients and terms of third order
  state_.newton.difference = 0;
  if (options_.hessian_products != 0) return state_.ask_product();
  const std::span<const double> along = newton_step_.direction();
  std::copy(along.begin(), along.end(), direction_.begin());
  state_.newton.difference = difference_angle / longest_block(direction_);
  place_trial(state_.newton.difference);
  return state_.ask(Phase::asked, options_.max_evaluations);
}

// On the sphere the Hessian of block i is P (H - (G.x) I) P.
void Solver::tell_product(std::span<const double> product) {
  require(asks_product(), "no product was requested");
  require(product.size() == shape_.size(), "the product must have as many entries as the point");
  if (!base::all_finite(product)) return tell_product_failure();
  if (product.data() != trial_gradient_.data()) std::copy(product.begin(), product.end(), trial_gradient_.begin());
  const std::span<const double> along = newton_step_.direction();
  with_dimension(shape_.dimension, [&](auto d) {
    for (std::size_t i = 0; i < shape_.count; ++i) {
      make_tangent(d, &x_[i * d], &trial_gradient_[i * d]);
      for (std::size_t k = i * d; k < (i + 1) * d; ++k)
        trial_gradient_[k] -= radial_[i] * along[k];
    }
  });
  ++state_.newton.products;
  state_.newton.known = 1;
  state_.phase = Phase::told_product;
}

void Solver::tell_product_failure() {
  require(asks_product(), "no product was requested");
  ++state_.newton.products;
  state_.newton.known = 0;
  state_.phase = Phase::told_product;
}

Request Solver::take_difference() {
  ++state_.newton.products;
  ++state_.gained_at;  // a product is no search in vain
  state_.newton.known = std::isfinite(state_.trial_value) ? 1 : 0;
  if (state_.newton.known != 0) {
    const double inverse = 1 / state_.newton.difference;
    for_each_block([&](auto d, std::size_t i) {
      transport(d, &trial_[i * d], &x_[i * d], &trial_gradient_[i * d]);
      for (std::size_t k = i * d; k < (i + 1) * d; ++k)
        trial_gradient_[k] = (trial_gradient_[k] - gradient_[k]) * inverse;
    });
  }
  return take_product();
}

Request Solver::take_product() {
  const bool complete =
      state_.newton.known != 0 ? newton_step_.advance(trial_gradient_, curvature_) : newton_step_.end_without_product();
  if (!complete) {
    report();
    return ask_product();
  }
  const std::span<const double> step = newton_step_.step();
  std::copy(step.begin(), step.end(), direction_.begin());
  state_.newton.difference = 0;
  place_trial(1);
  return state_.ask(Phase::asked, options_.max_evaluations);
}

Request Solver::take_newton_step() {
  constexpr double accepted = 0.1, poor = 0.25, good = 0.75;  // shares of the change of the model
  constexpr double least_angle = 0x1p-50;
  constexpr double hidden = 1e3;  // times the rounding of a value
  Newton& newton = state_.newton;
  const double blocks = std::sqrt(static_cast<double>(shape_.count));
  const double expected = -newton_step_.change(gradient_);
  // A fall that rounding of the values may hide is known from the slopes at both ends.
  const bool resolved = expected > hidden * (State::rounding_of(state_.value) + cancelled_part());
  const bool finite = std::isfinite(state_.trial_value);
  const double reached = resolved || !finite
                             ? state_.value - state_.trial_value
                             : -0.5 * (base::dot(gradient_, direction_) + base::dot(trial_gradient_, velocity_));
  const double share = reached / expected;
  if (!(share >= poor)) {
    newton.radius = 0.25 * std::min(newton.radius, newton_step_.length());
  } else if (share > good && newton_step_.at_boundary()) {
    newton.radius = std::min(2 * newton.radius, std::numbers::pi * blocks);
  }
  if (share > accepted) {
    ++state_.iterations;
    begin_at_trial();
    return Request::iteration;
  }
  if (newton.radius < least_angle * blocks) {
    return end_start(finite ? Stop::stalled : Stop::evaluation_failed);
  }
  return begin_newton_step();
}

}  // namespace orbicube::sphere_optimizer
