#include "projected_gradient/limited_memory.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vector_variants.h"
#include "projected_gradient/small_dense.h"
#include "projected_gradient/vector_math.h"

namespace orbicube::projected_gradient {
namespace {

// products += v row.
void add_scaled_row(const double* row, double v, std::span<double> products) {
  for (std::size_t k = 0; k < products.size(); ++k)
    products[k] += v * row[k];
}

// products += sum_j v_j row_j, `count` rows of `width`; four at once, so that products are loaded less often.
ORBICUBE_VECTOR_VARIANTS void add_rows(const double* rows, std::size_t count, std::size_t width, const double* v,
                                       double* __restrict products) {
  std::size_t j = 0;
  for (; j + 4 <= count; j += 4) {
    const double a = v[j], b = v[j + 1], c = v[j + 2], d = v[j + 3];
    if (a == 0 && b == 0 && c == 0 && d == 0) continue;
    const double* row = rows + j * width;
    for (std::size_t k = 0; k < width; ++k)
      products[k] += (a * row[k] + b * row[width + k]) + (c * row[2 * width + k] + d * row[3 * width + k]);
  }
  for (; j < count; ++j) {
    for (std::size_t k = 0; k < width; ++k)
      products[k] += v[j] * rows[j * width + k];
  }
}

// out_j = row_j . coefficients, of an even `width`.
ORBICUBE_VECTOR_VARIANTS void multiply_rows(const double* rows, std::size_t count, std::size_t width,
                                            const double* coefficients, double* __restrict out) {
  for (std::size_t j = 0; j < count; ++j) {
    const double* row = rows + j * width;
    base::Four sum{};
    std::size_t k = 0;
    for (; k + 4 <= width; k += 4)
      sum += base::load(row + k) * base::load(coefficients + k);
    for (; k < width; k += 2) {
      sum[0] += row[k] * coefficients[k];
      sum[1] += row[k + 1] * coefficients[k + 1];
    }
    out[j] = (sum[0] + sum[2]) + (sum[1] + sum[3]);
  }
}

// A pass over the table of a million unknowns takes longer than a host should wait.
constexpr std::size_t rows_between_reports = 1 << 16;

void report_row(const base::Host& host, std::size_t row) {
  if (row % rows_between_reports == rows_between_reports - 1) host.report("model", row, 0);
}

// Calls work(first, count) for parts of the rows, and reports after each.
template <class Work>
void for_parts(std::size_t rows, const base::Host& host, const Work& work) {
  for (std::size_t first = 0; first < rows; first += rows_between_reports) {
    if (first > 0) host.report("model", first, 0);
    work(first, std::min(rows_between_reports, rows - first));
  }
}

// Lower triangle of gram += the rows' outer products, four rows at once so that gram is loaded and stored less often.
ORBICUBE_VECTOR_VARIANTS void add_outer_products(const double* a, const double* b, const double* c, const double* d,
                                                 std::size_t width, double* __restrict gram) {
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
      change_products_(capacity * capacity, 0.0, memory),
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

  // Products of the new pair with all of them.
  const std::size_t width = 2 * capacity_;
  const std::span<double> with_s = std::span(gram_).first(width), with_y = std::span(gram_).subspan(width, width);
  std::fill_n(gram_.begin(), 2 * width, 0.0);  // gram_ is free between faces
  add_rows(table_.data(), n_, width, s.data(), with_s.data());
  add_rows(table_.data(), n_, width, y.data(), with_y.data());
  for (std::size_t k = 0; k < count_; ++k) {
    step_products_[slot * capacity_ + k] = step_products_[k * capacity_ + slot] = scale * with_s[k];
    mixed_products_[slot * capacity_ + k] = scale * with_s[capacity_ + k];
    mixed_products_[k * capacity_ + slot] = scale * with_y[k];
    change_products_[slot * capacity_ + k] = change_products_[k * capacity_ + slot] = scale * with_y[capacity_ + k];
  }
  prepared_ = false;
  return true;
}

void LimitedMemory::prepare() {
  if (prepared_ || empty()) return;
  prepared_ = rebuild();
  if (!prepared_) clear();
}

// With R the upper triangle of S'Y in the order of the pairs, D its diagonal, p = S'g and q = Y'g:
// B^-1 g = (g - Y w) / sigma + S t,  R w = p,  R't = D w + (Y'Y w - q) / sigma.
bool LimitedMemory::minimise(std::span<const double> gradient, std::span<double> d, const base::Host& host) {
  if (empty()) return false;
  const std::size_t c = count_;
  multiply_table(gradient, host);
  const std::span<double> w = std::span(dense_).first(c), t = std::span(dense_).subspan(c, c);
  for (std::size_t i = c; i-- > 0;) {
    const std::size_t row = slot_of_age(c - 1 - i);
    w[i] = products_[row];
    for (std::size_t k = i + 1; k < c; ++k)
      w[i] -= mixed_products_[row * capacity_ + slot_of_age(c - 1 - k)] * w[k];
    w[i] /= mixed_products_[row * capacity_ + row];
  }
  for (std::size_t i = 0; i < c; ++i) {
    const std::size_t row = slot_of_age(c - 1 - i);
    double changes = -products_[capacity_ + row];
    t[i] = mixed_products_[row * capacity_ + row] * w[i];
    for (std::size_t k = 0; k < c; ++k) {
      const std::size_t other = slot_of_age(c - 1 - k);
      changes += change_products_[row * capacity_ + other] * w[k];
      if (k < i) t[i] -= mixed_products_[other * capacity_ + row] * t[k];
    }
    t[i] = (t[i] + changes / sigma_) / mixed_products_[row * capacity_ + row];
  }
  std::fill(products_.begin(), products_.end(), 0.0);
  for (std::size_t i = 0; i < c; ++i) {
    const std::size_t row = slot_of_age(c - 1 - i);
    products_[row] = t[i];
    products_[capacity_ + row] = -w[i] / sigma_;
  }
  multiply_by_table(d, host);
  for (std::size_t j = 0; j < n_; ++j)
    d[j] = -(gradient[j] / sigma_ + d[j]);
  return all_finite(d);
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
  if (count_ == 0) return;
  for_parts(n_, host, [&](std::size_t first, std::size_t rows) {
    add_rows(table_.data() + first * 2 * capacity_, rows, 2 * capacity_, v.data() + first, products_.data());
  });
}

void LimitedMemory::multiply_by_table(std::span<double> out, const base::Host& host) const {
  for_parts(n_, host, [&](std::size_t first, std::size_t rows) {
    multiply_rows(table_.data() + first * 2 * capacity_, rows, 2 * capacity_, products_.data(), out.data() + first);
  });
}

void LimitedMemory::multiply(std::span<const double> v, std::span<double> out, const base::Host& host) const {
  multiply_table(v, host);
  solve_middle(middle_, middle_pivots_);
  multiply_by_table(out, host);
  for (std::size_t j = 0; j < n_; ++j)
    out[j] = sigma_ * v[j] - out[j];
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
  for_parts(n_, host, [&](std::size_t first, std::size_t rows) {
    std::array<double, 64> sums;
    for (std::size_t begin = first; begin < first + rows; begin += sums.size()) {
      const std::size_t some = std::min(sums.size(), first + rows - begin);
      multiply_rows(table_.data() + begin * 2 * capacity_, some, 2 * capacity_, products_.data(), sums.data());
      for (std::size_t k = 0; k < some; ++k) {
        if (free[begin + k]) d[begin + k] = -(d[begin + k] + sums[k] / sigma_) / sigma_;
      }
    }
  });
  set.project_to_face(d);
}

}  // namespace orbicube::projected_gradient
