#include "sphere_optimizer/newton_step.h"

#include <algorithm>
#include <cmath>

#include "base/sums.h"

namespace orbicube::sphere_optimizer {

NewtonStep::NewtonStep(const Shape& shape, bool used, std::pmr::memory_resource* memory)
    : shape_(shape),
      step_(used ? shape.size() : 0, 0.0, memory),
      product_(used ? shape.size() : 0, 0.0, memory),
      residual_(used ? shape.size() : 0, 0.0, memory),
      direction_(used ? shape.size() : 0, 0.0, memory) {}

void NewtonStep::begin(std::span<const double> gradient, std::span<const double> scale, double radius,
                       double accuracy) {
  std::fill(step_.begin(), step_.end(), 0.0);
  std::fill(product_.begin(), product_.end(), 0.0);
  std::fill(direction_.begin(), direction_.end(), 0.0);
  std::copy(gradient.begin(), gradient.end(), residual_.begin());
  state_ = State{};
  state_.radius = radius;
  state_.sufficient_square = accuracy * accuracy * base::dot(residual_, residual_);
  state_.residual_product = weighted_square(residual_, scale);
  state_.direction_square = state_.residual_product;
  begin_direction(0, scale);
}

// Sum of the squares of v divided by the scale.
double NewtonStep::weighted_square(std::span<const double> v, std::span<const double> scale) const {
  const std::size_t d = shape_.dimension;
  return base::blocked_sum(shape_.count, [&](std::size_t i) {
    double sum = 0;
    for (std::size_t k = i * d; k < (i + 1) * d; ++k)
      sum += v[k] * v[k];
    return sum / scale[i];
  });
}

// The preconditioned residual downwards plus a multiple of the last direction.
void NewtonStep::begin_direction(double factor, std::span<const double> scale) {
  const std::size_t d = shape_.dimension;
  for (std::size_t i = 0; i < shape_.count; ++i) {
    for (std::size_t k = i * d; k < (i + 1) * d; ++k)
      direction_[k] = factor * direction_[k] - residual_[k] / scale[i];
  }
}

void NewtonStep::move(double length, std::span<const double> product) {
  for (std::size_t j = 0; j < step_.size(); ++j) {
    step_[j] += length * direction_[j];
    product_[j] += length * product[j];
    residual_[j] += length * product[j];
  }
}

bool NewtonStep::advance(std::span<const double> product, std::span<const double> scale) {
  State& now = state_;
  ++now.products;
  const double curvature = base::dot(direction_, product);
  const double length = now.residual_product / curvature;
  const double next_square = now.step_square + length * (2 * now.step_direction + length * now.direction_square);
  if (!(curvature > 0) || !(next_square < now.radius * now.radius)) {
    // To the boundary, which lies ahead: the model falls all the way.
    const double room = std::max(0.0, now.radius * now.radius - now.step_square);
    const double root = std::sqrt(now.step_direction * now.step_direction + now.direction_square * room);
    move(room / (root + now.step_direction), product);
    now.at_boundary = 1;
    return true;
  }
  move(length, product);
  now.step_square = next_square;
  const std::uint64_t dimensions = shape_.count * (shape_.dimension - 1);
  if (base::dot(residual_, residual_) <= now.sufficient_square || now.products >= dimensions) return true;
  const double last = now.residual_product;
  now.residual_product = weighted_square(residual_, scale);
  const double factor = now.residual_product / last;
  begin_direction(factor, scale);
  now.step_direction = factor * (now.step_direction + length * now.direction_square);
  now.direction_square = now.residual_product + factor * factor * now.direction_square;
  return false;
}

bool NewtonStep::end_without_product() {
  state_.at_boundary = state_.products == 0 ? 1 : 0;
  if (state_.products > 0) return true;
  const double length = state_.radius / std::sqrt(state_.direction_square);
  for (std::size_t j = 0; j < step_.size(); ++j)
    step_[j] = length * direction_[j];
  return true;
}

double NewtonStep::length() const {
  return at_boundary() ? state_.radius : std::sqrt(state_.step_square);
}

double NewtonStep::change(std::span<const double> gradient) const {
  return base::dot(gradient, step_) + 0.5 * base::dot(step_, product_);
}

}  // namespace orbicube::sphere_optimizer
