#include "projected_gradient/dense_model.h"

#include <algorithm>
#include <cmath>

#include "projected_gradient/vector_math.h"

namespace orbicube::projected_gradient {
namespace {

// to += factor * from, from the entry `first` on; compilers make vector code of it, but not of sums.
void add_scaled(double* to, double factor, const double* from, std::size_t first, std::size_t end) {
  for (std::size_t j = first; j < end; ++j)
    to[j] += factor * from[j];
}

}  // namespace

DenseModel::DenseModel(std::size_t n, std::size_t capacity, std::pmr::memory_resource* memory)
    : n_(n),
      capacity_(capacity),
      steps_(n * capacity, 0.0, memory),
      changes_(n * capacity, 0.0, memory),
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
  next_ = (next_ + 1) % capacity_;
  count_ = std::min<std::uint64_t>(count_ + 1, capacity_);
  sigma_ = sigma > 0 && std::isfinite(sigma) ? sigma : dot(y, y) / curvature;
  if (rebuild()) return true;
  clear();
  return false;
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
  double modelled = 0, curvature = 0;
  for (std::size_t j = 0; j < n_; ++j) {
    modelled += s[j] * product_[j];
    curvature += s[j] * y[j];
  }
  if (!(modelled > 0) || !std::isfinite(1 / modelled)) return false;
  for (std::size_t i = 0; i < n_; ++i) {
    add_scaled(matrix_.data() + i * n_, -product_[i] / modelled, product_.data(), 0, n_);
    add_scaled(matrix_.data() + i * n_, y[i] / curvature, y, 0, n_);
  }
  return true;
}

// product_ = B v, by the rows of the symmetric B.
void DenseModel::multiply_matrix(const double* v) const {
  std::fill(product_.begin(), product_.end(), 0.0);
  for (std::size_t i = 0; i < n_; ++i)
    add_scaled(product_.data(), v[i], matrix_.data() + i * n_, 0, n_);
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
