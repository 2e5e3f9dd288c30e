#include "linear/iterative/gauss_seidel.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "linear/iterative/conjugate_gradients.h"

namespace orbicube::linear {
namespace {

// Rows between two reports: some milliseconds.
constexpr std::size_t rows_at_once = 16384;

template <int block>
Eigen::Map<Eigen::Matrix<double, block, 1>> entry_of(std::span<double> x, std::size_t row) {
  return Eigen::Map<Eigen::Matrix<double, block, 1>>(x.data() + block * row);
}

template <int block>
Eigen::Map<const Eigen::Matrix<double, block, 1>> entry_of(std::span<const double> x, std::size_t row) {
  return Eigen::Map<const Eigen::Matrix<double, block, 1>>(x.data() + block * row);
}

}  // namespace

template <int block>
void GaussSeidel<block>::factor(Matrix& matrix) {
  matrix_ = &matrix;
  inverse_.resize(matrix.rows());
  for (std::size_t v = 0; v < matrix.rows(); ++v) {
    typename Matrix::Block& at = matrix.diagonal[v];
    // Of size 1, or determinants may leave the range of double.
    const double size = at.trace();
    const double scale = size > 0 && std::isfinite(size) ? size : 1;
    for (const double added : {1e-9, 1e-6, 1.0}) {
      at.diagonal().array() += added * scale;
      inverse_[v] = typename Matrix::Block(at / scale).inverse() / scale;
      if (inverse_[v].allFinite()) break;
    }
    if (!inverse_[v].allFinite()) inverse_[v].setZero();
  }
  for (double& entry : matrix.corner_diagonal)
    entry = entry > 0 && std::isfinite(entry) ? entry * (1 + 1e-9) : 1;
}

template <int block>
void GaussSeidel<block>::forward(std::span<double> x) const {
  const Matrix& m = *matrix_;
  for (std::size_t v = 0; v < m.rows(); ++v) {
    if (v % rows_at_once == 0) host_.report("solve", 0, 0);
    Entry sum = entry_of<block>(x, v);
    for (Index i = m.row_begin[v]; i < m.row_begin[v + 1]; ++i)
      sum.noalias() -= m.lower[i] * entry_of<block>(x, m.column[i]);
    entry_of<block>(x, v).noalias() = inverse_[v] * sum;
  }
  const std::span<double> shared = x.subspan(Matrix::unknowns * m.rows());
  for (std::size_t s = 0; s < m.shared(); ++s) {
    double sum = shared[s];
    for (Index i = m.border_begin[s]; i < m.border_begin[s + 1]; ++i)
      sum -= m.border[i].dot(entry_of<block>(x, m.border_column[i]));
    for (Index i = m.corner_begin[s]; i < m.corner_begin[s + 1]; ++i)
      sum -= m.corner[i] * shared[m.corner_column[i]];
    shared[s] = sum / m.corner_diagonal[s];
  }
}

template <int block>
void GaussSeidel<block>::backward(std::span<double> x) const {
  const Matrix& m = *matrix_;
  const std::span<double> shared = x.subspan(Matrix::unknowns * m.rows());
  for (std::size_t s = m.shared(); s-- > 0;) {
    const double here = shared[s] / m.corner_diagonal[s];
    shared[s] = here;
    for (Index i = m.corner_begin[s]; i < m.corner_begin[s + 1]; ++i)
      shared[m.corner_column[i]] -= m.corner[i] * here;
    for (Index i = m.border_begin[s]; i < m.border_begin[s + 1]; ++i)
      entry_of<block>(x, m.border_column[i]) -= here * m.border[i];
  }
  for (std::size_t v = m.rows(); v-- > 0;) {
    if (v % rows_at_once == 0) host_.report("solve", 0, 0);
    const Entry here = inverse_[v] * entry_of<block>(x, v);
    entry_of<block>(x, v) = here;
    for (Index i = m.row_begin[v]; i < m.row_begin[v + 1]; ++i)
      entry_of<block>(x, m.column[i]).noalias() -= m.lower[i].transpose() * here;
  }
}

// Solves row v for x, with what x is elsewhere, and takes what that adds to the rows before off `sums`.
template <int block>
inline void GaussSeidel<block>::sweep_row(std::size_t v, std::span<const double> right, std::span<double> x,
                                          std::span<double> sums) const {
  const Matrix& m = *matrix_;
  if (v % rows_at_once == 0) host_.report("solve", 0, 0);
  Entry sum = entry_of<block>(right, v);
  for (Index i = m.row_begin[v]; i < m.row_begin[v + 1]; ++i)
    sum.noalias() -= m.lower[i] * entry_of<block>(x, m.column[i]);
  const Entry here = inverse_[v] * sum;
  entry_of<block>(x, v) = here;
  for (Index i = m.row_begin[v]; i < m.row_begin[v + 1]; ++i)
    entry_of<block>(sums, m.column[i]).noalias() -= m.lower[i].transpose() * here;
}

// Likewise a shared one.
template <int block>
inline void GaussSeidel<block>::sweep_shared(std::size_t s, std::span<const double> right, std::span<double> x,
                                             std::span<double> sums) const {
  const Matrix& m = *matrix_;
  const std::size_t first = Matrix::unknowns * m.rows();
  double sum = right[first + s];
  for (Index i = m.border_begin[s]; i < m.border_begin[s + 1]; ++i)
    sum -= m.border[i].dot(entry_of<block>(x, m.border_column[i]));
  for (Index i = m.corner_begin[s]; i < m.corner_begin[s + 1]; ++i)
    sum -= m.corner[i] * x[first + m.corner_column[i]];
  const double here = sum / m.corner_diagonal[s];
  x[first + s] = here;
  for (Index i = m.border_begin[s]; i < m.border_begin[s + 1]; ++i)
    entry_of<block>(sums, m.border_column[i]) -= here * m.border[i];
  for (Index i = m.corner_begin[s]; i < m.corner_begin[s + 1]; ++i)
    sums[first + m.corner_column[i]] -= m.corner[i] * here;
}

template <int block>
void GaussSeidel<block>::sweep_from_zero(std::span<const double> right, std::span<double> x,
                                         std::span<double> residual) const {
  std::fill(residual.begin(), residual.end(), 0.0);
  for (std::size_t v = 0; v < matrix_->rows(); ++v)
    sweep_row(v, right, x, residual);
  for (std::size_t s = 0; s < matrix_->shared(); ++s)
    sweep_shared(s, right, x, residual);
}

template <int block>
void GaussSeidel<block>::sweep_back(std::span<const double> right, std::span<double> x, std::span<double> sums) const {
  // Sums are over rows that have been swept.
  std::copy(right.begin(), right.end(), sums.begin());
  for (std::size_t s = matrix_->shared(); s-- > 0;)
    sweep_shared(s, sums, x, sums);
  for (std::size_t v = matrix_->rows(); v-- > 0;)
    sweep_row(v, sums, x, sums);
}

template <int block>
void GaussSeidel<block>::multiply_diagonal(std::span<const double> x, std::span<double> y) const {
  const Matrix& m = *matrix_;
  for (std::size_t v = 0; v < m.rows(); ++v)
    entry_of<block>(y, v).noalias() = m.diagonal[v] * entry_of<block>(x, v);
  for (std::size_t s = 0; s < m.shared(); ++s)
    y[Matrix::unknowns * m.rows() + s] = m.corner_diagonal[s] * x[Matrix::unknowns * m.rows() + s];
}

template <int block>
int GaussSeidel<block>::solve(std::span<const double> right, int max_steps, double tolerance,
                              std::span<double> solution) {
  // With A = L + D + L' and u = (D + L') x the system is (D + L)^-1 A (D + L')^-1 u = (D + L)^-1 b, preconditioned by
  // D.
  struct System {
    GaussSeidel& own;
    std::span<const double> right;
    std::span<double> solution;

    double start() {
      own.residual_.assign(right.begin(), right.end());
      for (Array<double>* of_size : {&own.search_, &own.image_, &own.product_})
        of_size->resize(right.size());
      own.forward(own.residual_);
      std::fill(solution.begin(), solution.end(), 0.0);
      own.multiply_diagonal(own.residual_, own.search_);
      return dot(own.residual_, own.search_);
    }
    double multiply() {
      own.image_ = own.search_;
      own.backward(own.image_);
      own.multiply_diagonal(own.image_, own.product_);
      for (std::size_t i = 0; i < right.size(); ++i)
        own.product_[i] = own.search_[i] - own.product_[i];
      own.forward(own.product_);
      double curvature = 0;
      for (std::size_t i = 0; i < right.size(); ++i) {
        own.product_[i] += own.image_[i];
        curvature += own.search_[i] * own.product_[i];
      }
      return curvature;
    }
    double advance(double length) {
      for (std::size_t i = 0; i < right.size(); ++i) {
        solution[i] += length * own.image_[i];
        own.residual_[i] -= length * own.product_[i];
      }
      own.multiply_diagonal(own.residual_, own.product_);
      return dot(own.residual_, own.product_);
    }
    void turn(double share) {
      for (std::size_t i = 0; i < right.size(); ++i)
        own.search_[i] = own.product_[i] + share * own.search_[i];
    }
  };
  System system{*this, right, solution};
  return conjugate_gradients(system, max_steps, tolerance).steps;
}

template class GaussSeidel<1>;
template class GaussSeidel<2>;
template class GaussSeidel<3>;

}  // namespace orbicube::linear
