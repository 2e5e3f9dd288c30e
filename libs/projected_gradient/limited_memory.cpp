#include "projected_gradient/limited_memory.h"

#include <algorithm>
#include <cmath>

#include "projected_gradient/small_dense.h"
#include "projected_gradient/vector_math.h"

namespace orbicube::projected_gradient {

LimitedMemory::LimitedMemory(std::size_t n, std::size_t m, std::size_t capacity, std::pmr::memory_resource* memory)
    : n_(n),
      capacity_(capacity),
      table_(n * 2 * capacity, 0.0, memory),
      step_products_(capacity * capacity, 0.0, memory),
      mixed_products_(capacity * capacity, 0.0, memory),
      plain_middle_(4 * capacity * capacity, 0.0, memory),
      middle_(plain_middle_.size(), 0.0, memory),
      face_middle_(plain_middle_.size(), 0.0, memory),
      middle_pivots_(2 * capacity, 0, memory),
      face_pivots_(2 * capacity, 0, memory),
      gram_(plain_middle_.size(), 0.0, memory),
      row_products_(m * 2 * capacity, 0.0, memory),
      row_column_(m, 0.0, memory),
      products_(2 * capacity, 0.0, memory) {}

bool LimitedMemory::push(std::span<const double> s, std::span<const double> y, double sigma) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double length = std::sqrt(dot(s, s)), curvature = dot(s, y), change = dot(y, y);
  if (!(length > 0) || !(curvature > epsilon * change) || !std::isfinite(change)) return false;
  if (!(change / curvature < 1e300)) return false;
  const std::size_t slot = count_ == 0 ? 0 : (newest_ + 1) % capacity_;
  const double scale = 1 / length;
  for (std::size_t j = 0; j < n_; ++j) {
    table_[j * 2 * capacity_ + slot] = s[j] * scale;
    table_[j * 2 * capacity_ + capacity_ + slot] = y[j] * scale;
  }
  count_ = std::min<std::uint64_t>(count_ + 1, capacity_);
  newest_ = slot;
  sigma_ = sigma > 0 && std::isfinite(sigma) ? sigma : change / curvature;

  // Products of the new pair with all of them, one pass over the table.
  const std::size_t c = count_, width = 2 * capacity_;
  base::Array<double>& sums = gram_;  // free between faces: [new s . S, new s . Y, S . new y]
  std::fill_n(sums.begin(), 3 * c, 0.0);
  for (std::size_t j = 0; j < n_; ++j) {
    const double* row = table_.data() + j * width;
    const double new_s = row[slot], new_y = row[capacity_ + slot];
    if (new_s == 0 && new_y == 0) continue;
    for (std::size_t k = 0; k < c; ++k)
      sums[k] += new_s * row[k];
    for (std::size_t k = 0; k < c; ++k)
      sums[c + k] += new_s * row[capacity_ + k];
    for (std::size_t k = 0; k < c; ++k)
      sums[2 * c + k] += new_y * row[k];
  }
  for (std::size_t k = 0; k < c; ++k) {
    step_products_[slot * capacity_ + k] = step_products_[k * capacity_ + slot] = sums[k];
    mixed_products_[slot * capacity_ + k] = sums[c + k];
    mixed_products_[k * capacity_ + slot] = sums[2 * c + k];
  }
  if (!rebuild()) {
    clear();
    return false;
  }
  return true;
}

bool LimitedMemory::rebuild() {
  const std::size_t c = count_, size = 2 * c;
  for (std::size_t i = 0; i < c; ++i) {
    for (std::size_t j = 0; j < c; ++j) {
      const double lower = age_of_slot(i) < age_of_slot(j) ? mixed_products_[i * capacity_ + j] : 0.0;
      plain_middle_[i * size + j] = sigma_ * step_products_[i * capacity_ + j];
      plain_middle_[i * size + c + j] = plain_middle_[(c + j) * size + i] = lower;
      plain_middle_[(c + i) * size + c + j] = i == j ? -mixed_products_[i * capacity_ + i] : 0.0;
    }
  }
  std::copy_n(plain_middle_.begin(), size * size, middle_.begin());
  return factor_dense(std::span(middle_).first(size * size), middle_pivots_, size);
}

void LimitedMemory::apply_inverse_middle(std::span<double> products) const {
  const std::size_t c = count_;
  for (std::size_t k = 0; k < c; ++k)
    products[k] *= sigma_;
  solve_dense(middle_, middle_pivots_, 2 * c, products);
  for (std::size_t k = 0; k < c; ++k)
    products[k] *= sigma_;
}

void LimitedMemory::multiply(std::span<const double> v, std::span<double> out) const {
  const std::size_t c = count_, width = 2 * capacity_;
  const std::span<double> products = std::span(products_).first(2 * c);
  std::fill(products.begin(), products.end(), 0.0);
  for (std::size_t j = 0; j < n_ && c > 0; ++j) {
    if (v[j] == 0) continue;
    const double* row = table_.data() + j * width;
    for (std::size_t k = 0; k < c; ++k)
      products[k] += row[k] * v[j];
    for (std::size_t k = 0; k < c; ++k)
      products[c + k] += row[capacity_ + k] * v[j];
  }
  apply_inverse_middle(products);
  for (std::size_t j = 0; j < n_; ++j) {
    const double* row = table_.data() + j * width;
    double sum = sigma_ * v[j];
    for (std::size_t k = 0; k < c; ++k)
      sum -= row[k] * products[k];
    for (std::size_t k = 0; k < c; ++k)
      sum -= row[capacity_ + k] * products[c + k];
    out[j] = sum;
  }
}

bool LimitedMemory::enter_face(const FeasibleSet& set) {
  const std::size_t c = count_, size = 2 * c, width = 2 * capacity_, m = set.rows();
  if (c == 0) return true;
  const std::span<const std::uint8_t> free = set.free();
  std::fill_n(gram_.begin(), size * size, 0.0);
  std::fill(row_products_.begin(), row_products_.end(), 0.0);
  for (std::size_t j = 0; j < n_; ++j) {
    if (!free[j]) continue;
    const double* s = table_.data() + j * width;
    const double* y = s + capacity_;
    for (std::size_t i = 0; i < c; ++i) {
      double* upper = gram_.data() + i * size;
      for (std::size_t k = 0; k <= i; ++k)
        upper[k] += s[i] * s[k];
      double* lower = gram_.data() + (c + i) * size;
      for (std::size_t k = 0; k < c; ++k)
        lower[k] += y[i] * s[k];
      for (std::size_t k = 0; k <= i; ++k)
        lower[c + k] += y[i] * y[k];
    }
    if (m == 0) continue;
    const auto rows = set.linear_rows().column_rows(j);
    const auto values = set.linear_rows().column_values(j);
    for (std::size_t p = 0; p < rows.size(); ++p) {
      double* to = row_products_.data() + rows[p] * width;
      for (std::size_t k = 0; k < c; ++k)
        to[k] += values[p] * s[k];
      for (std::size_t k = 0; k < c; ++k)
        to[c + k] += values[p] * y[k];
    }
  }
  for (std::size_t k = 0; k < size && m > 0; ++k) {
    for (std::size_t i = 0; i < m; ++i)
      row_column_[i] = row_products_[i * width + k];
    set.solve_normal(row_column_);
    for (std::size_t l = k; l < size; ++l) {
      double sum = 0;
      for (std::size_t i = 0; i < m; ++i)
        sum += row_products_[i * width + l] * row_column_[i];
      gram_[l * size + k] -= sum;
    }
  }
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t l = 0; l < size; ++l) {
      // U's first c columns are sigma S, so the blocks of U'U / sigma are sigma S'S, S'Y and Y'Y / sigma.
      const double scale = k < c && l < c ? sigma_ : (k >= c && l >= c ? 1 / sigma_ : 1.0);
      const double product = k >= l ? gram_[k * size + l] : gram_[l * size + k];
      face_middle_[k * size + l] = plain_middle_[k * size + l] - scale * product;
    }
  }
  return factor_dense(std::span(face_middle_).first(size * size), face_pivots_, size);
}

void LimitedMemory::minimise_in_face(const FeasibleSet& set, std::span<const double> gradient,
                                     std::span<double> d) const {
  const std::size_t c = count_, width = 2 * capacity_;
  std::copy(gradient.begin(), gradient.end(), d.begin());
  set.project_to_face(d);
  const std::span<double> products = std::span(products_).first(2 * c);
  std::fill(products.begin(), products.end(), 0.0);
  for (std::size_t j = 0; j < n_ && c > 0; ++j) {
    if (d[j] == 0) continue;
    const double* row = table_.data() + j * width;
    for (std::size_t k = 0; k < c; ++k)
      products[k] += row[k] * d[j];
    for (std::size_t k = 0; k < c; ++k)
      products[c + k] += row[capacity_ + k] * d[j];
  }
  // (sigma I - U N^-1 U')^-1 = I / sigma + U (N - U'U / sigma)^-1 U' / sigma^2.
  for (std::size_t k = 0; k < c; ++k)
    products[k] *= sigma_;
  if (c > 0) solve_dense(face_middle_, face_pivots_, 2 * c, products);
  for (std::size_t k = 0; k < c; ++k)
    products[k] *= sigma_;
  const std::span<const std::uint8_t> free = set.free();
  for (std::size_t j = 0; j < n_; ++j) {
    if (!free[j]) continue;
    const double* row = table_.data() + j * width;
    double sum = 0;
    for (std::size_t k = 0; k < c; ++k)
      sum += row[k] * products[k];
    for (std::size_t k = 0; k < c; ++k)
      sum += row[capacity_ + k] * products[c + k];
    d[j] = -(d[j] + sum / sigma_) / sigma_;
  }
  set.project_to_face(d);
}

}  // namespace orbicube::projected_gradient
