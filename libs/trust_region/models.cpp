#include "trust_region/models.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trust_region/dense.h"

namespace orbicube::trust_region {

Models::Models(std::size_t n, std::size_t outputs, bool least_squares, std::span<const double> sign, bool two_families,
               std::size_t capacity, std::pmr::memory_resource* memory)
    : n_(n),
      outputs_(outputs),
      least_squares_(least_squares),
      two_families_(two_families),
      sign_(outputs, 1.0, memory),
      outputs_at_(capacity * outputs, 0.0, memory),
      remembering_{base::Array<double>(outputs * n, 0.0, memory), base::Array<double>(outputs * n * n, 0.0, memory)},
      afresh_{base::Array<double>(two_families ? outputs * n : 0, 0.0, memory),
              base::Array<double>(two_families ? outputs * n * n : 0, 0.0, memory)},
      errors_(2, 0.0, memory),
      lagrange_gradient_(n, 0.0, memory),
      lagrange_hessian_(n * n, 0.0, memory),
      work_(2 * (n + capacity), 0.0, memory),
      values_(capacity, 0.0, memory),
      change_(outputs, 0.0, memory),
      slopes_(outputs * n, 0.0, memory) {
  std::copy(sign.begin(), sign.end(), sign_.begin());
}

double Models::objective(const double* outputs) const {
  if (!least_squares_) return outputs[0];
  double sum = 0;
  for (std::size_t i = 0; i < outputs_; ++i)
    sum += sign_[i] * outputs[i] * outputs[i];
  return sum;
}

void Models::store(std::size_t point, const double* outputs) {
  std::copy_n(outputs, outputs_, outputs_at_.data() + point * outputs_);
}

void Models::move(std::size_t from, std::size_t to) {
  if (from != to) store(to, row(from));
}

void Models::forget() {
  std::fill(remembering_.hessian.begin(), remembering_.hessian.end(), 0.0);
  std::fill(remembering_.gradient.begin(), remembering_.gradient.end(), 0.0);
  std::fill(errors_.begin(), errors_.end(), 0.0);
}

void Models::meet(const Interpolation& interpolation) {
  const std::size_t best = interpolation.best();
  for (std::size_t i = 0; i < outputs_; ++i) {
    double* hessian = remembering_.hessian.data() + i * n_ * n_;
    double* gradient = remembering_.gradient.data() + i * n_;
    // What the Hessian of before leaves to be met; its gradient is found anew.
    for (std::size_t j = 0; j < interpolation.size(); ++j)
      values_[j] = row(j)[i] - row(best)[i] - 0.5 * quadratic_form(hessian, n_, interpolation.offset(j));
    interpolation.interpolant(values_.data(), gradient, lagrange_hessian_.data(), work_.data());
    add_scaled(hessian, 1, lagrange_hessian_.data(), n_ * n_);
  }
}

void Models::learn(const Interpolation& interpolation, std::size_t j, const double* error) {
  interpolation.lagrange_function(j, lagrange_gradient_.data(), lagrange_hessian_.data());
  for (std::size_t i = 0; i < outputs_; ++i) {
    add_scaled(remembering_.gradient.data() + i * n_, error[i], lagrange_gradient_.data(), n_);
    add_scaled(remembering_.hessian.data() + i * n_ * n_, error[i], lagrange_hessian_.data(), n_ * n_);
  }
}

void Models::refresh(const Interpolation& interpolation) {
  if (!two_families_) return;
  for (std::size_t i = 0; i < outputs_; ++i) {
    for (std::size_t j = 0; j < interpolation.size(); ++j)
      values_[j] = row(j)[i];
    interpolation.interpolant(values_.data(), afresh_.gradient.data() + i * n_, afresh_.hessian.data() + i * n_ * n_,
                              work_.data());
  }
}

void Models::shift(const double* d) {
  for (std::size_t i = 0; i < outputs_; ++i) {
    for (std::size_t k = 0; k < n_; ++k)
      remembering_.gradient[i * n_ + k] += dot(remembering_.hessian.data() + (i * n_ + k) * n_, d, n_);
  }
}

void Models::judge(const double* d, const double* outputs, std::size_t best) {
  if (!two_families_) return;
  const double square = dot(d, d, n_);
  for (std::size_t k = 0; k < 2; ++k) {
    predict(k == 0 ? remembering_ : afresh_, d, change_.data());
    double sum = 0;
    for (std::size_t i = 0; i < outputs_; ++i) {
      const double error = outputs[i] - row(best)[i] - change_[i];
      sum += error * error;
    }
    errors_[k] = 0.5 * errors_[k] + sum / (square + 1e-300);
  }
}

void Models::predict(const Family& family, const double* d, double* change) const {
  for (std::size_t i = 0; i < outputs_; ++i) {
    change[i] =
        dot(family.gradient.data() + i * n_, d, n_) + 0.5 * quadratic_form(family.hessian.data() + i * n_ * n_, n_, d);
  }
}

double Models::change(const double* d, std::size_t best) {
  predict(d, change_.data());
  if (!least_squares_) return change_[0];
  double sum = 0;
  for (std::size_t i = 0; i < outputs_; ++i)
    sum += sign_[i] * change_[i] * (2 * row(best)[i] + change_[i]);
  return sum;
}

void Models::expand(const double* d, std::size_t best, double* gradient, double* hessian) {
  const Family& used = family();
  if (!least_squares_) {
    std::copy(used.hessian.begin(), used.hessian.end(), hessian);
    for (std::size_t k = 0; k < n_; ++k)
      gradient[k] = used.gradient[k] + dot(hessian + k * n_, d, n_);
    return;
  }
  predict(used, d, change_.data());
  std::fill_n(gradient, n_, 0.0);
  std::fill_n(hessian, n_ * n_, 0.0);
  for (std::size_t i = 0; i < outputs_; ++i) {
    const double* curvature = used.hessian.data() + i * n_ * n_;
    double* slope = slopes_.data() + i * n_;
    for (std::size_t k = 0; k < n_; ++k)
      slope[k] = used.gradient[i * n_ + k] + dot(curvature + k * n_, d, n_);
    const double weight = 2 * sign_[i] * (row(best)[i] + change_[i]);
    add_scaled(gradient, weight, slope, n_);
    for (std::size_t k = 0; k < n_; ++k)
      add_scaled(hessian + k * n_, weight, curvature + k * n_, k + 1);
    add_square_lower(hessian, n_, 2 * sign_[i], slope);
  }
  mirror_lower(hessian, n_);
}

}  // namespace orbicube::trust_region
