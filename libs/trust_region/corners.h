// What makes f of residuals that are not squared: h(r) with corners, and a smooth h_w that differs from it by a part of
// the width w, so that Newton's method finds steps. As w falls the steps become those of h (Grapiglia, Yuan, Yuan 2016
// have the trust region for h(r(x)) without derivatives, Nesterov 2005 the smoothing).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "trust_region/problem.h"

namespace orbicube::trust_region {

class Corners {
 public:
  explicit Corners(Objective objective) : objective_(objective) {}

  bool any() const { return objective_ != Objective::sum_of_squares; }
  // 0: h itself.
  double width() const { return width_; }
  void set_width(double width) { width_ = width; }

  // A bound on h_w - h.
  double error(std::size_t count) const {
    const double terms = static_cast<double>(count);
    if (objective_ == Objective::sum_of_magnitudes) return width_ * terms;
    return width_ * std::log(objective_ == Objective::max_magnitude ? 2 * terms : terms);
  }

  // h(r).
  double value(const double* r, std::size_t count) const {
    if (objective_ != Objective::sum_of_magnitudes) return largest(r, nullptr, count);
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i)
      sum += std::abs(r[i]);
    return sum;
  }

  // h_w(r + change), without a change where `change` is null: |r| becomes sqrt(r^2 + w^2), and the maximum
  // w log sum exp(r / w).
  double smooth_value(const double* r, const double* change, std::size_t count) const {
    const auto at = [&](std::size_t i) { return change != nullptr ? r[i] + change[i] : r[i]; };
    double sum = 0;
    if (objective_ == Objective::sum_of_magnitudes) {
      for (std::size_t i = 0; i < count; ++i)
        sum += width_ > 0 ? std::hypot(at(i), width_) : std::abs(at(i));
      return sum;
    }
    const double most = largest(r, change, count);
    if (!(width_ > 0)) return most;
    for (std::size_t i = 0; i < count; ++i) {
      sum += std::exp((at(i) - most) / width_);
      if (objective_ == Objective::max_magnitude) sum += std::exp((-at(i) - most) / width_);
    }
    return most + width_ * std::log(sum);
  }

  // Slopes p_i of h_w at r + change, and the Hessian diag(q) - t p p' by q; returns t. The width is positive.
  double expand(const double* r, const double* change, std::size_t count, double* p, double* q) const {
    if (objective_ == Objective::sum_of_magnitudes) {
      for (std::size_t i = 0; i < count; ++i) {
        const double at = r[i] + change[i], length = std::hypot(at, width_), part = width_ / length;
        p[i] = at / length;
        q[i] = part * part / length;
      }
      return 0;
    }
    const double most = largest(r, change, count);
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const double at = r[i] + change[i], above = std::exp((at - most) / width_);
      const double below = objective_ == Objective::max_magnitude ? std::exp((-at - most) / width_) : 0.0;
      p[i] = above - below;
      q[i] = above + below;
      sum += q[i];
    }
    for (std::size_t i = 0; i < count; ++i) {
      p[i] /= sum;
      q[i] /= sum * width_;
    }
    return 1 / width_;
  }

 private:
  // NaN where one of them is not a number.
  double largest(const double* r, const double* change, std::size_t count) const {
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < count; ++i) {
      const double at = change != nullptr ? r[i] + change[i] : r[i];
      if (std::isnan(at)) return at;
      most = std::max(most, objective_ == Objective::max_magnitude ? std::abs(at) : at);
    }
    return most;
  }

  Objective objective_;
  double width_ = 0;
};

}  // namespace orbicube::trust_region
