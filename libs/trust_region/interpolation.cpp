// Powell 2004, sections 3 and 4 for the update, Powell 2006 (NEWUOA), eq. 4.9 to 4.26 for its stable evaluation.
#include "trust_region/interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "trust_region/dense.h"

namespace orbicube::trust_region {
Interpolation::Interpolation(std::size_t n, std::pmr::memory_resource* memory)
    : n_(n),
      points_(memory),
      offsets_(memory),
      across_(memory),
      base_(memory),
      inverse_(memory),
      product_(memory),
      new_point_(memory),
      new_offset_(memory),
      work_(memory),
      matrix_(memory),
      work_square_(memory),
      order_(memory) {}

void Interpolation::allocate(std::size_t capacity, bool inverse) {
  capacity_ = capacity;
  stride_ = n_ + capacity;
  points_.resize(capacity * n_);
  if (!inverse) return;
  offsets_.resize(capacity * n_);
  across_.resize(n_ * capacity);
  for (auto* array : {&base_, &new_point_, &new_offset_})
    array->resize(n_);
  for (auto* array : {&inverse_, &matrix_, &work_square_})
    array->resize(stride_ * stride_);
  product_.resize(stride_);
  work_.resize(4 * stride_);
  order_.resize(stride_);
}

double Interpolation::distance_to_best(std::size_t j) const {
  double square = 0;
  trust_region::squared_distances(point(j), n_, 1, point(best_), &square);
  return std::sqrt(square);
}

void Interpolation::squared_distances(const double* x, double* squares) const {
  trust_region::squared_distances(points_.data(), n_, size_, x, squares);
}

void Interpolation::place(std::size_t j, const double* x) {
  std::copy_n(x, n_, points_.data() + j * n_);
}

void Interpolation::put_offset(std::size_t j, const double* s) {
  std::copy_n(s, n_, offsets_.data() + j * n_);
  for (std::size_t i = 0; i < n_; ++i)
    across_[i * capacity_ + j] = s[i];
}

// Base becomes the best point.
void Interpolation::put_base() {
  std::copy_n(point(best_), n_, base_.data());
  for (std::size_t j = 0; j < size_; ++j) {
    for (std::size_t i = 0; i < n_; ++i)
      new_offset_[i] = point(j)[i] - base_[i];
    put_offset(j, new_offset_.data());
  }
}

// Powell 2006, eq. 5.10 to 5.12: with s the base's move, the gradient rows get Y Omega, where column j of Y is
// (s'(s_j - s / 2)) (s_j - s / 2) + |s|^2 s / 4; Omega stays.
void Interpolation::move_base(double step) {
  const double* move = offset(best_);
  if (!(norm(move, n_) > 10 * step)) return;
  const std::size_t full = n_ + size_;
  for (std::size_t i = 0; i < full; ++i) {
    for (std::size_t k = 0; k < i; ++k)
      inverse_row(k)[i] = inverse_row(i)[k];
  }
  double* shift = work_.data();
  std::copy_n(move, n_, shift);
  const double quarter = 0.25 * dot(shift, shift, n_);
  double* columns = matrix_.data();    // Y by columns
  double* rows = work_square_.data();  // and by rows
  for (std::size_t j = 0; j < size_; ++j) {
    double* column = columns + j * n_;
    for (std::size_t i = 0; i < n_; ++i)
      column[i] = offset(j)[i] - 0.5 * shift[i];
    const double along = dot(shift, column, n_);
    for (std::size_t i = 0; i < n_; ++i)
      column[i] = rows[i * stride_ + j] = along * column[i] + quarter * shift[i];
  }
  // Gradient rows += Y times the rows of the points, then gradient columns += the columns of the points times Y'.
  add_product(inverse_.data(), 1, rows, inverse_row(n_), stride_, n_, size_, full);
  for (std::size_t i = 0; i < n_; ++i)
    add_combination(inverse_row(i), n_, inverse_row(i) + n_, columns, n_, size_);
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t k = 0; k < full; ++k) {
      if (k >= n_) {
        inverse_row(k)[i] = inverse_row(i)[k];
      } else if (k < i) {
        const double mean = 0.5 * (inverse_row(i)[k] + inverse_row(k)[i]);
        inverse_row(i)[k] = inverse_row(k)[i] = mean;
      }
    }
  }
  put_base();
}

bool Interpolation::prepare(const double* d) {
  // w - v of Powell's eq. 4.25: the best point's own column of the matrix is subtracted, so that nothing large cancels.
  const double* from = offset(best_);
  double* difference = work_.data();
  double square = 0, along = 0, from_square = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    new_point_[i] = point(best_)[i] + d[i];
    new_offset_[i] = from[i] + d[i];
    difference[i] = d[i];
    square += d[i] * d[i];
    along += d[i] * from[i];
    from_square += from[i] * from[i];
  }
  double* sum = work_.data() + stride_;
  for (std::size_t i = 0; i < n_; ++i)
    sum[i] = from[i] + new_offset_[i];
  double* along_step = work_.data() + 2 * stride_;
  double* along_sum = work_.data() + 3 * stride_;
  combination(along_step, size_, d, across_.data(), capacity_, n_);
  combination(along_sum, size_, sum, across_.data(), capacity_, n_);
  for (std::size_t j = 0; j < size_; ++j)
    difference[n_ + j] = 0.5 * along_step[j] * along_sum[j];
  const std::size_t full = n_ + size_;
  multiply_symmetric(inverse_.data(), stride_, full, difference, product_.data());
  const double quadratic = dot(difference, product_.data(), full);
  product_[n_ + best_] += 1;
  beta_ = along * along + square * (from_square + 2 * along + 0.5 * square) - quadratic;
  // The Lagrange values reproduce constants and coordinates.
  double total = 0, magnitude = 0;
  for (std::size_t j = 0; j < size_; ++j) {
    total += lagrange(j);
    magnitude += std::abs(lagrange(j));
  }
  return std::abs(total - 1) <= 1e-7 * std::max(1.0, magnitude);
}

// Of the whole inverse, from its lower triangle.
void Interpolation::copy_inverse_row(std::size_t row, double* to) const {
  std::copy_n(inverse_row(row), row + 1, to);
  for (std::size_t i = row + 1; i < n_ + size_; ++i)
    to[i] = inverse_row(i)[row];
}

bool Interpolation::replace(std::size_t j) {
  const std::size_t full = n_ + size_, row = n_ + j;
  const double tau = product_[row], a = alpha(j), sigma = a * beta_ + tau * tau;
  if (!(std::abs(sigma) > 1e-12 * std::max(1.0, tau * tau)) || !std::isfinite(sigma)) return false;
  double* column = work_.data();
  copy_inverse_row(row, column);
  double* away = work_.data() + stride_;
  double* first = work_.data() + 2 * stride_;
  double* second = work_.data() + 3 * stride_;
  for (std::size_t i = 0; i < full; ++i)
    away[i] = -product_[i];
  away[row] += 1;
  for (std::size_t i = 0; i < full; ++i) {
    first[i] = (a * away[i] + tau * column[i]) / sigma;
    second[i] = (tau * away[i] - beta_ * column[i]) / sigma;
  }
  add_two_products_lower(inverse_.data(), stride_, full, first, away, second, column);
  std::copy_n(new_point_.data(), n_, points_.data() + j * n_);
  put_offset(j, new_offset_.data());
  ++updates_;
  return true;
}

bool Interpolation::sound(std::size_t j) {
  if (j == best_) return true;
  double* row = work_.data();
  double* there = work_.data() + stride_;
  double* here = work_.data() + 2 * stride_;
  copy_inverse_row(n_ + j, row);
  double value = 0;
  for (std::size_t i = 0; i < n_; ++i)
    value += row[i] * (point(j)[i] - point(best_)[i]);
  // The difference of its quadratic part between the two points.
  combination(there, size_, offset(j), across_.data(), capacity_, n_);
  combination(here, size_, offset(best_), across_.data(), capacity_, n_);
  for (std::size_t k = 0; k < size_; ++k)
    there[k] = 0.5 * (there[k] - here[k]) * (there[k] + here[k]);
  value += dot(row + n_, there, size_);
  return std::abs(value - 1) < 1e-3;
}

bool Interpolation::append() {
  const std::size_t full = n_ + size_;
  if (size_ == capacity_ || !(beta_ > 0)) return false;
  add_square_lower(inverse_.data(), stride_, full, 1 / beta_, product_.data());
  for (std::size_t i = 0; i < full; ++i)
    inverse_row(full)[i] = -product_[i] / beta_;
  inverse_row(full)[full] = 1 / beta_;
  std::copy_n(new_point_.data(), n_, points_.data() + size_ * n_);
  put_offset(size_, new_offset_.data());
  ++size_;
  ++updates_;
  return true;
}

bool Interpolation::remove(std::size_t j) {
  const std::size_t full = n_ + size_, row = n_ + j, last = full - 1;
  const double a = alpha(j);
  const bool good = a > 0 && std::isfinite(a);
  if (good) {
    double* column = work_.data();
    copy_inverse_row(row, column);
    add_square_lower(inverse_.data(), stride_, full, -1 / a, column);
  }
  if (row != last) {
    std::copy_n(inverse_row(last), row, inverse_row(row));
    for (std::size_t i = row + 1; i < last; ++i)
      inverse_row(i)[row] = inverse_row(last)[i];
    inverse_row(row)[row] = inverse_row(last)[last];
    std::copy_n(point(size_ - 1), n_, points_.data() + j * n_);
    put_offset(j, offset(size_ - 1));
  }
  --size_;
  if (best_ == size_) best_ = j;
  ++updates_;
  return good;
}

// From the base to the best point: gradient += sum_j coefficient_j (s_j's_best) s_j.
void Interpolation::move_gradient(const double* coefficients, double* gradient) const {
  const double* best = offset(best_);
  if (std::all_of(best, best + n_, [](double entry) { return entry == 0; })) return;
  constexpr std::size_t some = 48;
  std::array<double, some> factor;
  for (std::size_t j = 0; j < size_; j += some) {
    const std::size_t count = std::min(some, size_ - j);
    combination(factor.data(), count, best, across_.data() + j, capacity_, n_);
    for (std::size_t k = 0; k < count; ++k)
      factor[k] *= coefficients[j + k];
    add_combination(gradient, n_, factor.data(), offset(j), n_, count);
  }
}

void Interpolation::quadratic(const double* coefficients, double* gradient, double* hessian) const {
  std::copy_n(coefficients, n_, gradient);
  move_gradient(coefficients + n_, gradient);
  sum_of_squares_lower(hessian, n_, coefficients + n_, offsets_.data(), size_);
  mirror_lower(hessian, n_);
}

void Interpolation::lagrange_function(std::size_t j, double* gradient, double* hessian, double* coefficients) const {
  copy_inverse_row(n_ + j, coefficients);
  quadratic(coefficients, gradient, hessian);
}

void Interpolation::interpolant(const double* values, double* gradient, double* hessian, double* work) const {
  // Of the values minus the one at the best point.
  double* shifted = work + stride_;
  std::fill_n(shifted, n_, 0.0);
  for (std::size_t j = 0; j < size_; ++j)
    shifted[n_ + j] = values[j] - values[best_];
  multiply_symmetric(inverse_.data(), stride_, n_ + size_, shifted, work);
  quadratic(work, gradient, hessian);
}

void Interpolation::transform(const double* c, const double* best) {
  const double* center = point(best_);
  for (std::size_t j = 0; j < size_; ++j) {
    if (j == best_) continue;
    for (std::size_t i = 0; i < n_; ++i)
      new_offset_[i] = point(j)[i] - center[i];
    double* to = points_.data() + j * n_;
    multiply(c, n_, n_, n_, new_offset_.data(), to);
    add_scaled(to, 1, best, n_);
  }
  place(best_, best);
}

}  // namespace orbicube::trust_region
