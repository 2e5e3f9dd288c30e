// Powell 2004, sections 3 and 4 for the update, Powell 2006 (NEWUOA), eq. 4.9 to 4.26 for its stable evaluation.
#include "trust_region/interpolation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "trust_region/dense.h"

namespace orbicube::trust_region {
namespace {

// Exchanges row k of a with the one below that has the largest entry in column k, and their entries of `factors`, which
// may be null. False when that entry is zero or not finite.
bool take_pivot(double* a, std::size_t stride, std::size_t size, std::size_t k, std::uint32_t* order, double* factors) {
  std::size_t pivot = k;
  for (std::size_t i = k + 1; i < size; ++i) {
    if (std::abs(a[i * stride + k]) > std::abs(a[pivot * stride + k])) pivot = i;
  }
  order[k] = static_cast<std::uint32_t>(pivot);
  const double head = a[pivot * stride + k];
  if (head == 0 || !std::isfinite(head)) return false;
  if (pivot == k) return true;
  std::swap_ranges(a + k * stride, a + k * stride + size, a + pivot * stride);
  if (factors != nullptr) std::swap(factors[k], factors[pivot]);
  return true;
}

void divide_by_pivot(double* row, std::size_t size, std::size_t k) {
  const double head = row[k];
  row[k] = 1;
  for (std::size_t j = 0; j < size; ++j)
    row[j] /= head;
}

// Replaces a (size x size, rows `stride` apart) by its inverse, Gauss-Jordan with row interchanges, two columns at a
// time so that the rows are read and written half as often. `factors` and `first` are work of `size` each. False when a
// pivot is zero or not finite.
bool invert(double* a, std::size_t stride, std::size_t size, std::uint32_t* order, double* factors, double* first) {
  std::size_t k = 0;
  for (; k + 1 < size; k += 2) {
    if (!take_pivot(a, stride, size, k, order, nullptr)) return false;
    double* row = a + k * stride;
    divide_by_pivot(row, size, k);
    // Column k + 1 first, since the next pivot is chosen from it.
    for (std::size_t i = 0; i < size; ++i) {
      factors[i] = i == k ? 0 : a[i * stride + k];
      if (i == k) continue;
      a[i * stride + k] = 0;
      a[i * stride + k + 1] -= factors[i] * row[k + 1];
    }
    if (!take_pivot(a, stride, size, k + 1, order, factors)) return false;
    std::copy_n(row, size, first);
    first[k + 1] = 0;
    double* second = row + stride;
    add_scaled(second, -factors[k + 1], first, size);
    divide_by_pivot(second, size, k + 1);
    const auto factor_of_second = [&](std::size_t i) {
      const double factor = a[i * stride + k + 1];
      a[i * stride + k + 1] = 0;
      return -factor;
    };
    // Rows by twos as well: k is even, so that k and k + 1 are such a pair, of which only row k is to change.
    for (std::size_t i = 0; i < size; i += 2) {
      double* upper = a + i * stride;
      if (i == k || i + 1 == size) {
        add_one_after_other(upper, -factors[i], first, factor_of_second(i), second, size);
        continue;
      }
      double* lower = upper + stride;
      const double f0 = -factors[i], f1 = factor_of_second(i), g0 = -factors[i + 1], g1 = factor_of_second(i + 1);
      add_two_to_two(upper, f0, f1, lower, g0, g1, first, second, size);
    }
  }
  if (k < size) {
    if (!take_pivot(a, stride, size, k, order, nullptr)) return false;
    double* row = a + k * stride;
    divide_by_pivot(row, size, k);
    for (std::size_t i = 0; i < size; ++i) {
      if (i == k) continue;
      const double factor = a[i * stride + k];
      a[i * stride + k] = 0;
      add_scaled(a + i * stride, -factor, row, size);
    }
  }
  for (k = size; k-- > 0;) {
    const std::size_t pivot = order[k];
    if (pivot == k) continue;
    for (std::size_t i = 0; i < size; ++i)
      std::swap(a[i * stride + k], a[i * stride + pivot]);
  }
  return true;
}

}  // namespace

Interpolation::Interpolation(std::size_t n, std::size_t capacity, std::pmr::memory_resource* memory)
    : n_(n),
      capacity_(capacity),
      stride_(n + capacity),
      points_(capacity * n, 0.0, memory),
      offsets_(capacity * n, 0.0, memory),
      base_(n, 0.0, memory),
      inverse_(stride_ * stride_, 0.0, memory),
      product_(stride_, 0.0, memory),
      new_point_(n, 0.0, memory),
      new_offset_(n, 0.0, memory),
      work_(4 * stride_, 0.0, memory),
      matrix_(stride_ * stride_, 0.0, memory),
      work_square_(stride_ * stride_, 0.0, memory),
      order_(stride_, 0, memory) {}

double Interpolation::distance_to_best(std::size_t j) const {
  double sum = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    const double away = point(j)[i] - point(best_)[i];
    sum += away * away;
  }
  return std::sqrt(sum);
}

void Interpolation::place(std::size_t j, const double* x) {
  std::copy_n(x, n_, points_.data() + j * n_);
}

bool Interpolation::rebuild() {
  ++rebuilds_;
  updates_ = 0;
  std::copy_n(point(best_), n_, base_.data());
  double* lengths = work_.data();
  double mean = 0;
  for (std::size_t j = 0; j < size_; ++j) {
    for (std::size_t i = 0; i < n_; ++i)
      offsets_[j * n_ + i] = point(j)[i] - base_[i];
    lengths[j] = norm(offset(j), n_);
    if (j == best_) continue;
    if (!(lengths[j] > 0) || !std::isfinite(lengths[j])) return false;
    mean += std::log(lengths[j]);
  }
  if (size_ < n_ + 1) return false;
  mean = std::exp(mean / static_cast<double>(size_ - 1));
  // The system of the points other than the best, whose value is the constant; lengths divided out: lambda_j |s_j|^2
  // and g / mean are its unknowns.
  const std::size_t count = n_ + size_ - 1;
  double* matrix = matrix_.data();
  double* reduced = work_square_.data();
  std::fill(matrix, matrix + count * stride_, 0.0);
  const auto index = [&](std::size_t j) { return n_ + (j < best_ ? j : j - 1); };
  for (std::size_t j = 0; j < size_; ++j) {
    if (j == best_) continue;
    double* row = matrix + index(j) * stride_;
    for (std::size_t i = 0; i < n_; ++i) {
      row[i] = offset(j)[i] / lengths[j] * (mean / lengths[j]);
      matrix[i * stride_ + index(j)] = row[i];
    }
    for (std::size_t k = 0; k <= j; ++k) {
      if (k == best_) continue;
      const double cosine = dot(offset(j), offset(k), n_) / (lengths[j] * lengths[k]);
      row[index(k)] = matrix[index(k) * stride_ + index(j)] = 0.5 * cosine * cosine;
    }
  }
  for (std::size_t i = 0; i < count; ++i)
    std::copy_n(matrix + i * stride_, count, reduced + i * stride_);
  if (!invert(reduced, stride_, count, order_.data(), work_.data() + stride_, work_.data() + 2 * stride_)) return false;
  // One step of Newton's iteration for the inverse, H + H (I - W H), also says how good it is. inverse_ is still free.
  double worst = 0;
  for (std::size_t i = 0; i < count; ++i)
    std::fill_n(inverse_row(i), count, 0.0);
  add_product(inverse_.data(), -1, matrix, reduced, stride_, count, count, count);
  for (std::size_t i = 0; i < count; ++i) {
    double* row = inverse_row(i);
    row[i] += 1;
    for (std::size_t k = 0; k < count; ++k)
      worst = std::max(worst, std::abs(row[k]));
  }
  if (!(worst < 1e-3)) return false;
  for (std::size_t i = 0; i < count; ++i)
    std::copy_n(reduced + i * stride_, count, matrix + i * stride_);
  add_product(matrix, 1, reduced, inverse_.data(), stride_, count, count, count);
  // Back to full size and units. The Lagrange function of the best point is 1 minus the others.
  double* unit = work_.data() + stride_;
  std::fill_n(unit, n_, mean);
  for (std::size_t j = 0; j < size_; ++j) {
    if (j != best_) unit[index(j)] = 1 / (lengths[j] * lengths[j]);
  }
  const std::size_t full = n_ + size_;
  for (std::size_t i = 0; i < full; ++i)
    std::fill_n(inverse_row(i), full, 0.0);
  const auto wide = [&](std::size_t row) { return row < n_ + best_ ? row : row + 1; };
  double* best_row = inverse_row(n_ + best_);
  for (std::size_t i = 0; i < count; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const double entry = 0.5 * (matrix[i * stride_ + k] + matrix[k * stride_ + i]) * unit[i] * unit[k];
      inverse_row(wide(i))[wide(k)] = entry;
      if (k >= n_) sum -= entry;
    }
    inverse_row(wide(i))[n_ + best_] = sum;
    best_row[wide(i)] = sum;
  }
  double corner = 0;
  for (std::size_t i = n_; i < count; ++i)
    corner -= best_row[wide(i)];
  best_row[n_ + best_] = corner;
  return true;
}

// Powell 2006, eq. 5.10 to 5.12: with s the base's move, the gradient rows get Y Omega, where column j of Y is
// (s'(s_j - s / 2)) (s_j - s / 2) + |s|^2 s / 4; Omega stays.
void Interpolation::move_base(double step) {
  const double* move = offset(best_);
  if (!(norm(move, n_) > 10 * step)) return;
  const std::size_t full = n_ + size_;
  double* shift = work_.data();
  std::copy_n(move, n_, shift);
  const double quarter = 0.25 * dot(shift, shift, n_);
  double* columns = matrix_.data();  // Y by columns
  for (std::size_t j = 0; j < size_; ++j) {
    double* column = columns + j * n_;
    for (std::size_t i = 0; i < n_; ++i)
      column[i] = offset(j)[i] - 0.5 * shift[i];
    const double along = dot(shift, column, n_);
    for (std::size_t i = 0; i < n_; ++i)
      column[i] = along * column[i] + quarter * shift[i];
  }
  // Gradient rows += Y times the rows of the points, then gradient columns += the columns of the points times Y'.
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t j = 0; j < size_; ++j)
      add_scaled(inverse_row(i), columns[j * n_ + i], inverse_row(n_ + j), full);
  }
  for (std::size_t i = 0; i < n_; ++i) {
    double* row = inverse_row(i);
    for (std::size_t j = 0; j < size_; ++j)
      add_scaled(row, row[n_ + j], columns + j * n_, n_);
  }
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
  std::copy_n(point(best_), n_, base_.data());
  for (std::size_t j = 0; j < size_; ++j) {
    for (std::size_t i = 0; i < n_; ++i)
      offsets_[j * n_ + i] = point(j)[i] - base_[i];
  }
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
  for (std::size_t j = 0; j < size_; ++j)
    difference[n_ + j] = 0.5 * dot(offset(j), d, n_) * dot(offset(j), sum, n_);
  const std::size_t full = n_ + size_;
  multiply(inverse_.data(), stride_, full, full, difference, product_.data());
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

bool Interpolation::replace(std::size_t j) {
  const std::size_t full = n_ + size_, row = n_ + j;
  const double tau = product_[row], a = alpha(j), sigma = a * beta_ + tau * tau;
  if (!(std::abs(sigma) > 1e-12 * std::max(1.0, tau * tau)) || !std::isfinite(sigma)) return false;
  double* column = work_.data();
  std::copy_n(inverse_row(row), full, column);
  double* away = work_.data() + stride_;
  for (std::size_t i = 0; i < full; ++i)
    away[i] = -product_[i];
  away[row] += 1;
  for (std::size_t i = 0; i < full; ++i) {
    const double first = (a * away[i] + tau * column[i]) / sigma, second = (tau * away[i] - beta_ * column[i]) / sigma;
    add_two_scaled(inverse_row(i), first, away, second, column, full);
  }
  std::copy_n(new_point_.data(), n_, points_.data() + j * n_);
  std::copy_n(new_offset_.data(), n_, offsets_.data() + j * n_);
  ++updates_;
  return true;
}

bool Interpolation::sound(std::size_t j) {
  if (j == best_) return true;
  const double* row = inverse_row(n_ + j);
  double value = 0;
  for (std::size_t i = 0; i < n_; ++i)
    value += row[i] * (point(j)[i] - point(best_)[i]);
  // The difference of its quadratic part between the two points.
  for (std::size_t k = 0; k < size_; ++k) {
    const double there = dot(offset(k), offset(j), n_), here = dot(offset(k), offset(best_), n_);
    value += 0.5 * row[n_ + k] * (there - here) * (there + here);
  }
  return std::abs(value - 1) < 1e-3;
}

bool Interpolation::append() {
  const std::size_t full = n_ + size_;
  if (size_ == capacity_ || !(beta_ > 0)) return false;
  for (std::size_t i = 0; i < full; ++i) {
    const double factor = product_[i] / beta_;
    add_scaled(inverse_row(i), factor, product_.data(), full);
    inverse_row(i)[full] = -factor;
    inverse_row(full)[i] = -factor;
  }
  inverse_row(full)[full] = 1 / beta_;
  std::copy_n(new_point_.data(), n_, points_.data() + size_ * n_);
  std::copy_n(new_offset_.data(), n_, offsets_.data() + size_ * n_);
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
    std::copy_n(inverse_row(row), full, column);
    for (std::size_t i = 0; i < full; ++i)
      add_scaled(inverse_row(i), -column[i] / a, column, full);
  }
  if (row != last) {
    std::copy_n(inverse_row(last), full, inverse_row(row));
    for (std::size_t i = 0; i < full; ++i)
      inverse_row(i)[row] = inverse_row(i)[last];
    inverse_row(row)[row] = inverse_row(last)[last];
    std::copy_n(point(size_ - 1), n_, points_.data() + j * n_);
    std::copy_n(offset(size_ - 1), n_, offsets_.data() + j * n_);
  }
  --size_;
  if (best_ == size_) best_ = j;
  ++updates_;
  return good;
}

// From the base to the best point: gradient += sum_j coefficient_j (s_j's_best) s_j.
void Interpolation::move_gradient(const double* coefficients, double* gradient) const {
  for (std::size_t j = 0; j < size_; ++j)
    add_scaled(gradient, coefficients[j] * dot(offset(j), offset(best_), n_), offset(j), n_);
}

void Interpolation::lagrange_function(std::size_t j, double* gradient, double* hessian) const {
  const double* row = inverse_row(n_ + j);
  std::copy_n(row, n_, gradient);
  move_gradient(row + n_, gradient);
  sum_of_squares_lower(hessian, n_, row + n_, offsets_.data(), size_);
  mirror_lower(hessian, n_);
}

void Interpolation::interpolant(const double* values, double* gradient, double* hessian, double* work) const {
  // Of the values minus the one at the best point.
  double* shifted = work + stride_;
  for (std::size_t j = 0; j < size_; ++j)
    shifted[j] = values[j] - values[best_];
  for (std::size_t i = 0; i < n_ + size_; ++i)
    work[i] = dot(inverse_row(i) + n_, shifted, size_);
  std::copy_n(work, n_, gradient);
  move_gradient(work + n_, gradient);
  sum_of_squares_lower(hessian, n_, work + n_, offsets_.data(), size_);
  mirror_lower(hessian, n_);
}

double Interpolation::coefficient(std::size_t j, const double* values) const {
  // Rows of the points sum to zero over the points, so that no constant matters.
  return dot(inverse_row(n_ + j) + n_, values, size_);
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
