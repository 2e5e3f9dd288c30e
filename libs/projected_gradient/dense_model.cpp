#include "projected_gradient/dense_model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vector_variants.h"
#include "projected_gradient/vector_math.h"

namespace orbicube::projected_gradient {
namespace {

// to += factor * from, from the entry `first` on; compilers make vector code of it, but not of sums.
void add_scaled(double* to, double factor, const double* from, std::size_t first, std::size_t end) {
  for (std::size_t j = first; j < end; ++j)
    to[j] += factor * from[j];
}

// The matrix += first p p' + second y y', n x n.
ORBICUBE_VECTOR_VARIANTS void add_two_squares(double* __restrict matrix, std::size_t n, double first, const double* p,
                                              double second, const double* y) {
  for (std::size_t i = 0; i < n; ++i) {
    const double a = first * p[i], b = second * y[i];
    for (std::size_t j = 0; j < n; ++j)
      matrix[i * n + j] += a * p[j] + b * y[j];
  }
}

// out = matrix v, by the rows of the symmetric n x n matrix.
ORBICUBE_VECTOR_VARIANTS void multiply_symmetric(const double* matrix, std::size_t n, const double* v,
                                                 double* __restrict out) {
  for (std::size_t j = 0; j < n; ++j)
    out[j] = 0;
  std::size_t i = 0;
  for (; i + 2 <= n; i += 2) {
    for (std::size_t j = 0; j < n; ++j)
      out[j] += v[i] * matrix[i * n + j] + v[i + 1] * matrix[(i + 1) * n + j];
  }
  for (std::size_t j = 0; i < n && j < n; ++j)
    out[j] += v[i] * matrix[i * n + j];
}

ORBICUBE_INLINE double dot_of_few(const double* a, const double* b, std::size_t count) {
  std::array<double, 4> sum{};
  std::size_t j = 0;
  for (; j + 4 <= count; j += 4) {
    for (std::size_t k = 0; k < 4; ++k)
      sum[k] += a[j + k] * b[j + k];
  }
  for (std::size_t k = 0; j < count; ++j, ++k)
    sum[k] += a[j] * b[j];
  return (sum[0] + sum[2]) + (sum[1] + sum[3]);
}

// The pairs from the oldest on, in two runs of a ring: `first` of them from the slot `oldest`, the others from slot 0.
struct Pairs {
  const double *steps, *changes, *curvatures;
  std::size_t n, oldest, first, count;

  std::size_t slot(std::size_t k) const { return k < first ? oldest + k : k - first; }
};

// d = -B^-1 d; parts: one entry a pair.
ORBICUBE_VECTOR_VARIANTS void run_two_loops(const Pairs& pairs, double sigma, double* __restrict parts,
                                            double* __restrict d) {
  const std::size_t n = pairs.n;
  for (std::size_t k = pairs.count; k-- > 0;) {
    const std::size_t slot = pairs.slot(k);
    const double* y = pairs.changes + slot * n;
    const double part = parts[k] = dot_of_few(pairs.steps + slot * n, d, n) / pairs.curvatures[slot];
    for (std::size_t j = 0; j < n; ++j)
      d[j] -= part * y[j];
  }
  for (std::size_t j = 0; j < n; ++j)
    d[j] = -d[j] / sigma;
  for (std::size_t k = 0; k < pairs.count; ++k) {
    const std::size_t slot = pairs.slot(k);
    const double* s = pairs.steps + slot * n;
    const double part = dot_of_few(pairs.changes + slot * n, d, n) / pairs.curvatures[slot] + parts[k];
    for (std::size_t j = 0; j < n; ++j)
      d[j] -= part * s[j];
  }
}

}  // namespace

DenseModel::DenseModel(std::size_t n, std::size_t capacity, std::pmr::memory_resource* memory)
    : n_(n),
      capacity_(capacity),
      steps_(n * capacity, 0.0, memory),
      changes_(n * capacity, 0.0, memory),
      curvatures_(capacity, 0.0, memory),
      parts_(capacity, 0.0, memory),
      matrix_(n * n, 0.0, memory),
      factor_(n * n, 0.0, memory),
      in_face_(n, 0, memory),
      product_(n, 0.0, memory) {}

bool DenseModel::push(std::span<const double> s, std::span<const double> y, double sigma) {
  const double curvature = safe_curvature(s, y);
  if (curvature == 0) return false;
  const double scale = 1 / std::sqrt(dot(s, s));
  for (std::size_t j = 0; j < n_; ++j) {
    steps_[next_ * n_ + j] = s[j] * scale;
    changes_[next_ * n_ + j] = y[j] * scale;
  }
  curvatures_[next_] = curvature * scale * scale;
  next_ = (next_ + 1) % capacity_;
  count_ = std::min<std::uint64_t>(count_ + 1, capacity_);
  sigma_ = sigma > 0 && std::isfinite(sigma) ? sigma : dot(y, y) / curvature;
  prepared_ = false;
  return true;
}

bool DenseModel::minimise(std::span<const double> gradient, std::span<double> d, const base::Host&) {
  if (empty()) return false;
  std::copy(gradient.begin(), gradient.end(), d.begin());
  const std::size_t oldest = (next_ + capacity_ - count_) % capacity_;
  run_two_loops({steps_.data(), changes_.data(), curvatures_.data(), n_, oldest, capacity_ - oldest,
                 static_cast<std::size_t>(count_)},
                sigma_, parts_.data(), d.data());
  return all_finite(d);
}

void DenseModel::prepare() {
  if (prepared_ || empty()) return;
  prepared_ = rebuild();
  if (!prepared_) clear();
}

bool DenseModel::rebuild() {
  std::fill(matrix_.begin(), matrix_.end(), 0.0);
  for (std::size_t j = 0; j < n_; ++j)
    matrix_[j * n_ + j] = sigma_;
  for (std::size_t age = count_; age > 0; --age) {
    if (!add_pair((next_ + capacity_ - age) % capacity_)) return false;
  }
  return true;
}

// B <- B - B s s'B / s'B s + y y' / s'y; false where rounding has left no curvature along s.
bool DenseModel::add_pair(std::size_t slot) {
  const double* s = steps_.data() + slot * n_;
  const double* y = changes_.data() + slot * n_;
  multiply_matrix(s);
  const double modelled = dot_of_few(s, product_.data(), n_);
  if (!(modelled > 0) || !std::isfinite(1 / modelled)) return false;
  add_two_squares(matrix_.data(), n_, -1 / modelled, product_.data(), 1 / curvatures_[slot], y);
  return true;
}

// product_ = B v.
void DenseModel::multiply_matrix(const double* v) const {
  multiply_symmetric(matrix_.data(), n_, v, product_.data());
}

void DenseModel::multiply(std::span<const double> v, std::span<double> out, const base::Host&) const {
  if (!empty()) multiply_matrix(v.data());
  for (std::size_t j = 0; j < n_; ++j)
    out[j] = empty() ? sigma_ * v[j] : product_[j];
}

// The upper Cholesky factor R of the face's block of B = R'R.
bool DenseModel::enter_face(const FeasibleSet& set, const base::Host&) {
  face_size_ = 0;
  for (std::size_t j = 0; j < n_; ++j) {
    if (set.free()[j]) in_face_[face_size_++] = static_cast<std::uint32_t>(j);
  }
  for (std::size_t i = 0; i < face_size_ && !empty(); ++i) {
    for (std::size_t j = i; j < face_size_; ++j)
      factor_[i * n_ + j] = matrix_[in_face_[i] * n_ + in_face_[j]];
  }
  for (std::size_t k = 0; k < face_size_ && !empty(); ++k) {
    double* row = factor_.data() + k * n_;
    if (!(row[k] > 0)) {
      clear();
      return false;
    }
    const double diagonal = std::sqrt(row[k]);
    for (std::size_t j = k; j < face_size_; ++j)
      row[j] /= diagonal;
    for (std::size_t i = k + 1; i < face_size_; ++i)
      add_scaled(factor_.data() + i * n_, -row[i], row, i, face_size_);
  }
  return true;
}

void DenseModel::minimise_in_face(const FeasibleSet&, std::span<const double> gradient, std::span<double> d,
                                  const base::Host&) const {
  std::fill(d.begin(), d.end(), 0.0);
  for (std::size_t i = 0; i < face_size_; ++i)
    product_[i] = -gradient[in_face_[i]];
  for (std::size_t i = 0; i < face_size_ && !empty(); ++i) {
    const double* row = factor_.data() + i * n_;
    product_[i] /= row[i];
    add_scaled(product_.data(), -product_[i], row, i + 1, face_size_);
  }
  for (std::size_t i = face_size_; i-- > 0;) {
    const double* row = factor_.data() + i * n_;
    for (std::size_t k = i + 1; k < face_size_ && !empty(); ++k)
      product_[i] -= row[k] * product_[k];
    product_[i] /= empty() ? sigma_ : row[i];
    d[in_face_[i]] = product_[i];
  }
}

}  // namespace orbicube::projected_gradient
