#include "projected_gradient/limited_memory.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "projected_gradient/small_dense.h"
#include "projected_gradient/vector_math.h"

namespace orbicube::projected_gradient {
namespace {

// products += v row, and row . coefficients, over one row of the table; compilers make vector code of both.
void add_scaled_row(const double* row, double v, std::span<double> products) {
  for (std::size_t k = 0; k < products.size(); ++k)
    products[k] += v * row[k];
}

double row_dot(const double* row, std::span<const double> coefficients) {
  double even = 0, odd = 0;  // the width is even
  for (std::size_t k = 0; k < coefficients.size(); k += 2) {
    even += row[k] * coefficients[k];
    odd += row[k + 1] * coefficients[k + 1];
  }
  return even + odd;
}

// A pass over the table of a million unknowns takes longer than a host should wait.
void report_row(const base::Host& host, std::size_t row) {
  constexpr std::size_t every = 1 << 16;
  if (row % every == every - 1) host.report("model", row, 0);
}

// Lower triangle of gram += the rows' outer products, four rows at once so that gram is loaded and stored less often.
void add_outer_products(const double* a, const double* b, const double* c, const double* d, std::size_t width,
                        double* gram) {
  for (std::size_t i = 0; i < width; ++i) {
    double* to = gram + i * width;
    for (std::size_t k = 0; k <= i; ++k)
      to[k] += (a[i] * a[k] + b[i] * b[k]) + (c[i] * c[k] + d[i] * d[k]);
  }
}

}  // namespace

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
      products_(2 * capacity, 0.0, memory),
      dense_(2 * capacity, 0.0, memory) {}

bool LimitedMemory::push(std::span<const double> s, std::span<const double> y, double sigma) {
  const double curvature = safe_curvature(s, y);
  if (curvature == 0) return false;
  const std::size_t slot = count_ == 0 ? 0 : (newest_ + 1) % capacity_;
  const double scale = 1 / std::sqrt(dot(s, s));
  for (std::size_t j = 0; j < n_; ++j) {
    table_[j * 2 * capacity_ + slot] = s[j] * scale;
    table_[j * 2 * capacity_ + capacity_ + slot] = y[j] * scale;
  }
  count_ = std::min<std::uint64_t>(count_ + 1, capacity_);
  newest_ = slot;
  sigma_ = sigma > 0 && std::isfinite(sigma) ? sigma : dot(y, y) / curvature;

  // Products of the new pair with all of them, one pass over the table.
  const std::size_t width = 2 * capacity_;
  const std::span<double> with_s = std::span(gram_).first(width), with_y = std::span(gram_).subspan(width, width);
  std::fill_n(gram_.begin(), 2 * width, 0.0);  // gram_ is free between faces
  for (std::size_t j = 0; j < n_; ++j) {
    const double* row = table_.data() + j * width;
    if (row[slot] != 0) add_scaled_row(row, row[slot], with_s);
    if (row[capacity_ + slot] != 0) add_scaled_row(row, row[capacity_ + slot], with_y);
  }
  for (std::size_t k = 0; k < count_; ++k) {
    step_products_[slot * capacity_ + k] = step_products_[k * capacity_ + slot] = with_s[k];
    mixed_products_[slot * capacity_ + k] = with_s[capacity_ + k];
    mixed_products_[k * capacity_ + slot] = with_y[k];
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

// Between products with the table, which has room for more pairs than there are, and the small systems.
void LimitedMemory::solve_middle(std::span<const double> factors, std::span<const std::uint32_t> pivots) const {
  const std::size_t c = count_;
  const std::span<double> wide(products_), dense = std::span(dense_).first(2 * c);
  for (std::size_t k = 0; k < c; ++k) {
    dense[k] = sigma_ * wide[k];
    dense[c + k] = wide[capacity_ + k];
  }
  solve_dense(factors, pivots, 2 * c, dense);
  std::fill(wide.begin(), wide.end(), 0.0);
  for (std::size_t k = 0; k < c; ++k) {
    wide[k] = sigma_ * dense[k];
    wide[capacity_ + k] = dense[c + k];
  }
}

void LimitedMemory::multiply_table(std::span<const double> v, const base::Host& host) const {
  std::fill(products_.begin(), products_.end(), 0.0);
  for (std::size_t j = 0; j < n_ && count_ > 0; ++j) {
    report_row(host, j);
    if (v[j] != 0) add_scaled_row(table_.data() + j * 2 * capacity_, v[j], products_);
  }
}

void LimitedMemory::multiply(std::span<const double> v, std::span<double> out, const base::Host& host) const {
  multiply_table(v, host);
  solve_middle(middle_, middle_pivots_);
  for (std::size_t j = 0; j < n_; ++j) {
    report_row(host, j);
    out[j] = sigma_ * v[j] - (count_ > 0 ? row_dot(table_.data() + j * 2 * capacity_, products_) : 0.0);
  }
}

bool LimitedMemory::enter_face(const FeasibleSet& set, const base::Host& host) {
  const std::size_t c = count_, size = 2 * c, width = 2 * capacity_, m = set.rows();
  if (c == 0) return true;
  const std::span<const std::uint8_t> free = set.free();
  std::fill(gram_.begin(), gram_.end(), 0.0);
  std::fill(row_products_.begin(), row_products_.end(), 0.0);
  std::fill(dense_.begin(), dense_.end(), 0.0);
  std::array<const double*, 4> batch;
  std::size_t waiting = 0;
  for (std::size_t j = 0; j < n_; ++j) {
    report_row(host, j);
    if (!free[j]) continue;
    const double* row = table_.data() + j * width;
    batch[waiting++] = row;
    if (waiting == batch.size()) {
      add_outer_products(batch[0], batch[1], batch[2], batch[3], width, gram_.data());
      waiting = 0;
    }
    if (m == 0) continue;
    const auto rows = set.linear_rows().column_rows(j);
    const auto values = set.linear_rows().column_values(j);
    for (std::size_t p = 0; p < rows.size(); ++p) {
      add_scaled_row(row, values[p], std::span(row_products_).subspan(rows[p] * width, width));
    }
  }
  for (std::size_t k = 0; k < waiting; ++k) {
    add_outer_products(batch[k], dense_.data(), dense_.data(), dense_.data(), width, gram_.data());  // dense_ is zero
  }
  for (std::size_t k = 0; k < width && m > 0; ++k) {
    for (std::size_t i = 0; i < m; ++i)
      row_column_[i] = row_products_[i * width + k];
    set.solve_normal(row_column_);
    for (std::size_t l = k; l < width; ++l) {
      double sum = 0;
      for (std::size_t i = 0; i < m; ++i)
        sum += row_products_[i * width + l] * row_column_[i];
      gram_[l * width + k] -= sum;
    }
  }
  for (std::size_t k = 0; k < size; ++k) {
    for (std::size_t l = 0; l < size; ++l) {
      // U's first c columns are sigma S, so the blocks of U'U / sigma are sigma S'S, S'Y and Y'Y / sigma.
      const double scale = k < c && l < c ? sigma_ : (k >= c && l >= c ? 1 / sigma_ : 1.0);
      const std::size_t wide_k = k < c ? k : capacity_ + k - c, wide_l = l < c ? l : capacity_ + l - c;
      const double product = gram_[std::max(wide_k, wide_l) * width + std::min(wide_k, wide_l)];
      face_middle_[k * size + l] = plain_middle_[k * size + l] - scale * product;
    }
  }
  return factor_dense(std::span(face_middle_).first(size * size), face_pivots_, size);
}

void LimitedMemory::minimise_in_face(const FeasibleSet& set, std::span<const double> gradient, std::span<double> d,
                                     const base::Host& host) const {
  std::copy(gradient.begin(), gradient.end(), d.begin());
  set.project_to_face(d);
  // (sigma I - U N^-1 U')^-1 = I / sigma + U (N - U'U / sigma)^-1 U' / sigma^2.
  multiply_table(d, host);
  solve_middle(face_middle_, face_pivots_);
  const std::span<const std::uint8_t> free = set.free();
  for (std::size_t j = 0; j < n_; ++j) {
    report_row(host, j);
    if (!free[j]) continue;
    const double sum = count_ > 0 ? row_dot(table_.data() + j * 2 * capacity_, products_) : 0.0;
    d[j] = -(d[j] + sum / sigma_) / sigma_;
  }
  set.project_to_face(d);
}

}  // namespace orbicube::projected_gradient
