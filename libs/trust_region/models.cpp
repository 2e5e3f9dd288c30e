#include "trust_region/models.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trust_region/dense.h"

namespace orbicube::trust_region {

Models::Models(std::size_t n, std::size_t outputs, bool of_residuals, std::span<const double> sign, bool two_families,
               std::pmr::memory_resource* memory, Objective objective)
    : n_(n),
      outputs_(outputs),
      of_residuals_(of_residuals),
      two_families_(two_families),
      corners_(objective),
      sign_(outputs, 1.0, memory),
      outputs_at_(memory),
      remembering_{base::Array<double>(memory), base::Array<double>(memory)},
      afresh_{base::Array<double>(memory), base::Array<double>(memory)},
      errors_(2, 0.0, memory),
      lagrange_gradient_(memory),
      lagrange_hessian_(memory),
      work_(memory),
      values_(memory),
      change_(memory),
      surprise_(memory),
      surprise_afresh_(memory),
      at_(memory),
      slopes_(memory),
      weights_(memory),
      moved_(memory),
      moved_afresh_(memory) {
  std::copy(sign.begin(), sign.end(), sign_.begin());
}

void Models::allocate(std::size_t capacity, bool quadratics) {
  outputs_at_.resize(capacity * outputs_);
  if (!quadratics) return;
  for (Family* family : {&remembering_, &afresh_}) {
    if (family == &afresh_ && !two_families_) continue;
    family->gradient.resize(outputs_ * n_);
    family->hessian.resize(outputs_ * n_ * n_);
  }
  lagrange_gradient_.resize(n_);
  lagrange_hessian_.resize(n_ * n_);
  work_.resize(2 * (n_ + capacity));
  values_.resize(capacity);
  change_.resize(outputs_);
  surprise_.resize(outputs_);
  surprise_afresh_.resize(two_families_ ? outputs_ : 0);
  if (!of_residuals_) return;
  at_.resize(n_);
  weights_.resize(2 * outputs_);
  for (auto* slopes : {&slopes_, &moved_})
    slopes->resize(outputs_ * n_);
  moved_afresh_.resize(two_families_ ? outputs_ * n_ : 0);
}

double Models::objective(const double* outputs) const {
  if (!of_residuals_) return outputs[0];
  if (has_corners()) return corners_.value(outputs, outputs_);
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
  measured_ = false;
  doubts_ = 0;
  std::fill(remembering_.hessian.begin(), remembering_.hessian.end(), 0.0);
  std::fill(remembering_.gradient.begin(), remembering_.gradient.end(), 0.0);
  std::fill(errors_.begin(), errors_.end(), 0.0);
}

void Models::meet(const Interpolation& interpolation) {
  measured_ = false;
  const std::size_t best = interpolation.best();
  for (std::size_t i = 0; i < outputs_; ++i) {
    double* hessian = remembering_.hessian.data() + i * n_ * n_;
    double* gradient = remembering_.gradient.data() + i * n_;
    // What the Hessian of before leaves to be met; its gradient is found again.
    for (std::size_t j = 0; j < interpolation.size(); ++j)
      values_[j] = row(j)[i] - row(best)[i] - 0.5 * quadratic_form(hessian, n_, interpolation.offset(j));
    interpolation.interpolant(values_.data(), gradient, lagrange_hessian_.data(), work_.data());
    add_scaled(hessian, 1, lagrange_hessian_.data(), n_ * n_);
  }
  make_afresh(interpolation);
}

void Models::make_afresh(const Interpolation& interpolation) {
  stale_ = 0;
  if (!two_families_) return;
  for (std::size_t i = 0; i < outputs_; ++i) {
    for (std::size_t j = 0; j < interpolation.size(); ++j)
      values_[j] = row(j)[i];
    interpolation.interpolant(values_.data(), afresh_.gradient.data() + i * n_, afresh_.hessian.data() + i * n_ * n_,
                              work_.data());
  }
}

// The interpolant of minimum norm on the other points: what point j's square contributes goes, without a change of the
// values at the others, when lambda_j / alpha_j of its Lagrange function is taken off.
void Models::leave(const Interpolation& interpolation, std::size_t j) {
  if (!two_families_ || stale_ != 0) return;
  measured_ = false;
  const double alpha = interpolation.alpha(j), away = interpolation.distance_to_best(j);
  // Where the Lagrange function is almost linear the quotient has no digits.
  if (!(alpha * away * away * away * away > 1e-6)) {
    stale_ = 1;
    return;
  }
  interpolation.lagrange_function(j, lagrange_gradient_.data(), lagrange_hessian_.data(), work_.data());
  // The coefficients of the Lagrange function sum to zero over the points, so that no constant of the values matters.
  const double* coefficients = work_.data() + n_;
  for (std::size_t i = 0; i < outputs_; ++i) {
    for (std::size_t k = 0; k < interpolation.size(); ++k)
      values_[k] = row(k)[i];
    const double factor = -dot(coefficients, values_.data(), interpolation.size()) / alpha;
    add_scaled(afresh_.gradient.data() + i * n_, factor, lagrange_gradient_.data(), n_);
    add_scaled(afresh_.hessian.data() + i * n_ * n_, factor, lagrange_hessian_.data(), n_ * n_);
  }
}

void Models::expect(const double* d, const double* outputs, std::size_t best) {
  learned_ = remade_ = false;
  if (of_residuals_) {
    predict_with_slopes(remembering_, d, surprise_.data(), moved_.data());
    if (two_families_) predict_with_slopes(afresh_, d, surprise_afresh_.data(), moved_afresh_.data());
  } else {
    predict(remembering_, d, surprise_.data());
    if (two_families_) predict(afresh_, d, surprise_afresh_.data());
  }
  for (std::size_t i = 0; i < outputs_; ++i) {
    const double change = outputs[i] - row(best)[i];
    surprise_[i] = change - surprise_[i];
    if (two_families_) surprise_afresh_[i] = change - surprise_afresh_[i];
  }
}

void Models::learn(const Interpolation& interpolation, std::size_t j) {
  measured_ = false;
  learned_ = true;
  interpolation.lagrange_function(j, lagrange_gradient_.data(), lagrange_hessian_.data(), work_.data());
  const auto add = [&](Family& family, const base::Array<double>& surprise) {
    for (std::size_t i = 0; i < outputs_; ++i) {
      add_scaled(family.gradient.data() + i * n_, surprise[i], lagrange_gradient_.data(), n_);
      add_scaled(family.hessian.data() + i * n_ * n_, surprise[i], lagrange_hessian_.data(), n_ * n_);
    }
  };
  add(remembering_, surprise_);
  if (!two_families_) return;
  if (stale_ != 0) {
    make_afresh(interpolation);
    remade_ = true;
  } else {
    add(afresh_, surprise_afresh_);
  }
}

void Models::shift(const double* d) {
  measured_ = false;
  const auto shift_all = [&](Family& family) {
    for (std::size_t i = 0; i < family.gradient.size(); ++i)
      family.gradient[i] += dot(family.hessian.data() + i * n_, d, n_);
  };
  if (!of_residuals_) {
    shift_all(remembering_);
    shift_all(afresh_);
    return;
  }
  double* learned = work_.data();
  if (learned_) multiply(lagrange_hessian_.data(), n_, n_, n_, d, learned);
  const auto shift_known = [&](Family& family, const base::Array<double>& moved, const base::Array<double>& surprise) {
    add_scaled(family.gradient.data(), 1, moved.data(), outputs_ * n_);
    for (std::size_t i = 0; learned_ && i < outputs_; ++i)
      add_scaled(family.gradient.data() + i * n_, surprise[i], learned, n_);
  };
  shift_known(remembering_, moved_, surprise_);
  if (two_families_ && remade_) shift_all(afresh_);
  if (two_families_ && !remade_) shift_known(afresh_, moved_afresh_, surprise_afresh_);
}

// g becomes C^-T g, H becomes C^-T H C^-1.
void Models::transform(const double* inverse) {
  measured_ = false;
  double* half = lagrange_hessian_.data();
  for (Family* family : {&remembering_, &afresh_}) {
    for (std::size_t i = 0; i * n_ < family->gradient.size(); ++i) {
      double* gradient = family->gradient.data() + i * n_;
      double* hessian = family->hessian.data() + i * n_ * n_;
      std::copy_n(gradient, n_, lagrange_gradient_.data());
      std::fill_n(gradient, n_, 0.0);
      std::fill_n(half, n_ * n_, 0.0);
      for (std::size_t k = 0; k < n_; ++k) {
        add_scaled(gradient, lagrange_gradient_[k], inverse + k * n_, n_);
        for (std::size_t a = 0; a < n_; ++a)
          add_scaled(half + k * n_, hessian[k * n_ + a], inverse + a * n_, n_);
      }
      std::fill_n(hessian, n_ * n_, 0.0);
      for (std::size_t k = 0; k < n_; ++k) {
        for (std::size_t a = 0; a < n_; ++a)
          add_scaled(hessian + a * n_, inverse[k * n_ + a], half + k * n_, a + 1);
      }
      mirror_lower(hessian, n_);
    }
  }
}

void Models::judge(const double* d, const double* outputs, std::size_t best) {
  if (!two_families_) return;
  measured_ = false;
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

// Powell 2006, section 8: a Hessian of values far away, as of steps that were much too long, is forgotten where the
// gradient of the interpolant without it is a tenth of the model's, three times in a row.
void Models::doubt_memory(const Interpolation& interpolation, bool poor) {
  constexpr double times_smaller = 10;
  constexpr std::uint64_t enough = 3;
  if (of_residuals_ || stale_ != 0) return;
  if (!poor) {
    doubts_ = 0;
    return;
  }
  const double *gradient = afresh_.gradient.data(), *hessian = afresh_.hessian.data();
  if (!two_families_) {
    for (std::size_t j = 0; j < interpolation.size(); ++j)
      values_[j] = row(j)[0];
    interpolation.interpolant(values_.data(), lagrange_gradient_.data(), lagrange_hessian_.data(), work_.data());
    gradient = lagrange_gradient_.data();
    hessian = lagrange_hessian_.data();
  }
  if (!(norm(remembering_.gradient.data(), n_) >= times_smaller * norm(gradient, n_))) {
    doubts_ = 0;
    return;
  }
  if (++doubts_ < enough) return;
  doubts_ = 0;
  std::copy_n(gradient, n_, remembering_.gradient.data());
  std::copy_n(hessian, n_ * n_, remembering_.hessian.data());
}

void Models::predict(const Family& family, const double* d, double* change) const {
  for (std::size_t i = 0; i < outputs_; ++i) {
    change[i] =
        dot(family.gradient.data() + i * n_, d, n_) + 0.5 * quadratic_form(family.hessian.data() + i * n_ * n_, n_, d);
  }
}

// The same with H_i d, which costs nothing more.
void Models::predict_with_slopes(const Family& family, const double* d, double* change, double* slopes) const {
  for (std::size_t i = 0; i < outputs_; ++i) {
    double* slope = slopes + i * n_;
    multiply(family.hessian.data() + i * n_ * n_, n_, n_, n_, d, slope);
    change[i] = dot(family.gradient.data() + i * n_, d, n_) + 0.5 * dot(slope, d, n_);
  }
}

// Puts what the family in use predicts at d into change_ and slopes_, unless it is there.
void Models::measure(const double* d) {
  if (measured_ && std::equal(d, d + n_, at_.begin())) return;
  measured_ = true;
  std::copy_n(d, n_, at_.data());
  if (std::all_of(d, d + n_, [](double entry) { return entry == 0; })) {
    std::fill(change_.begin(), change_.end(), 0.0);
    std::fill(slopes_.begin(), slopes_.end(), 0.0);
  } else {
    predict_with_slopes(family(), d, change_.data(), slopes_.data());
  }
}

double Models::change(const double* d, std::size_t best) {
  if (!of_residuals_) {
    predict(family(), d, change_.data());
    return change_[0];
  }
  measure(d);
  if (has_corners())
    return corners_.smooth_value(row(best), change_.data(), outputs_) -
           corners_.smooth_value(row(best), nullptr, outputs_);
  double sum = 0;
  for (std::size_t i = 0; i < outputs_; ++i)
    sum += sign_[i] * change_[i] * (2 * row(best)[i] + change_[i]);
  return sum;
}

double Models::reach(double radius) const {
  const Family& used = family();
  double most = 0;
  for (std::size_t i = 0; i < outputs_; ++i) {
    const double slope = norm(used.gradient.data() + i * n_, n_),
                 bend = norm(used.hessian.data() + i * n_ * n_, n_ * n_);
    most = std::max(most, radius * (slope + 0.5 * radius * bend));
  }
  return most;
}

void Models::expand(const double* d, std::size_t best, double* gradient, double* hessian) {
  const Family& used = family();
  if (!of_residuals_) {
    std::copy(used.hessian.begin(), used.hessian.end(), hessian);
    for (std::size_t k = 0; k < n_; ++k)
      gradient[k] = used.gradient[k] + dot(hessian + k * n_, d, n_);
    return;
  }
  measure(d);
  measured_ = false;  // slopes_ becomes the residuals' gradients
  double* of_squares = weights_.data() + outputs_;
  double shared = 0;
  if (has_corners()) {
    shared = corners_.expand(row(best), change_.data(), outputs_, weights_.data(), of_squares);
  } else {
    for (std::size_t i = 0; i < outputs_; ++i) {
      weights_[i] = 2 * sign_[i] * (row(best)[i] + change_[i]);
      of_squares[i] = 2 * sign_[i];
    }
  }
  add_scaled(slopes_.data(), 1, used.gradient.data(), outputs_ * n_);
  combination(gradient, n_, weights_.data(), slopes_.data(), n_, outputs_);
  sum_of_squares_lower(hessian, n_, of_squares, slopes_.data(), outputs_);
  if (shared != 0) add_square_lower(hessian, n_, n_, -shared, gradient);
  // Few Hessians at once, so that each is read in its order.
  constexpr std::size_t some = 4;
  for (std::size_t i = 0; i < outputs_; i += some)
    add_combination(hessian, n_ * n_, weights_.data() + i, used.hessian.data() + i * n_ * n_, n_ * n_,
                    std::min(some, outputs_ - i));
  mirror_lower(hessian, n_);
}

}  // namespace orbicube::trust_region
