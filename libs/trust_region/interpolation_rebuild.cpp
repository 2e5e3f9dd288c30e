// The inverse of the interpolation points' KKT matrix made from the points alone, with lengths divided out.
#include <algorithm>
#include <cmath>

#include "trust_region/dense.h"
#include "trust_region/interpolation.h"

namespace orbicube::trust_region {
namespace {

// An inverse whose product with its matrix is wrong by less is not refined.
constexpr double good_inverse = 1e-9;

// A symmetric matrix in its lower triangle.
struct LowerTriangle {
  double* entries;
  std::size_t stride, size;

  double diagonal(std::size_t i) const { return entries[i * stride + i]; }
  double& operator()(std::size_t i, std::size_t k) const {
    return i < k ? entries[k * stride + i] : entries[i * stride + k];
  }
  void copy_column(std::size_t k, double* to) const {
    std::copy_n(entries + k * stride, k + 1, to);
    for (std::size_t i = k + 1; i < size; ++i)
      to[i] = entries[i * stride + k];
  }
};

// Marks the largest diagonal entry that is left as swept and returns its row.
template <class Diagonal>
std::size_t take_pivot(std::size_t size, std::uint32_t* swept, const Diagonal& diagonal) {
  std::size_t best = size;
  double most = 0;
  for (std::size_t i = 0; i < size; ++i) {
    if (swept[i] != 0) continue;
    const double magnitude = std::abs(diagonal(i));
    if (magnitude > most || best == size) {
      most = magnitude;
      best = i;
    }
  }
  swept[best] = 1;
  return best;
}

// Sweeps pivot p = 1 / d, whose column is `column`.
void sweep(const LowerTriangle& matrix, std::size_t p, double d, double* column) {
  column[p] = 0;
  add_square_lower(matrix.entries, matrix.stride, matrix.size, -d, column);
  for (std::size_t i = 0; i < matrix.size; ++i)
    matrix(i, p) = d * column[i];
  matrix(p, p) = -d;
}

// A pivot, the inverse of its value, its column, and room for this column scaled.
struct Pivot {
  std::size_t row;
  double inverse;
  double* column;
  double* scaled;
};

// Sweeps the first pivot and then the second one, whose column is as the first sweep leaves it. `across`: the second
// pivot's entry of the first column over the first pivot.
void sweep_both(const LowerTriangle& matrix, const Pivot& first, const Pivot& second, double across) {
  const std::size_t p = first.row, q = second.row;
  const double d = first.inverse, f = second.inverse;
  first.column[p] = first.column[q] = second.column[p] = second.column[q] = 0;
  for (std::size_t i = 0; i < matrix.size; ++i) {
    first.scaled[i] = -d * first.column[i];
    second.scaled[i] = -f * second.column[i];
  }
  add_two_products_lower(matrix.entries, matrix.stride, matrix.size, first.scaled, first.column, second.scaled,
                         second.column);
  for (std::size_t i = 0; i < matrix.size; ++i) {
    matrix(i, p) = across * second.scaled[i] - first.scaled[i];
    matrix(i, q) = -second.scaled[i];
  }
  matrix(p, p) = -d - across * across * f;
  matrix(p, q) = across * f;
  matrix(q, q) = -f;
}

// Replaces a symmetric matrix (lower triangle of size x size, rows `stride` apart) by minus its inverse: Gauss-Jordan
// sweeps, two at a time so that the triangle is read and written half as often. The pivot is the largest entry that is
// left on the diagonal. A KKT matrix has zeros there, but sweeps of its points fill them in: only when neither a
// point's nor a gradient's entry is left are all of them zero, and then the points are not poised. `work` has 4 `size`
// entries. False when a pivot is zero or not finite.
bool invert_symmetric(double* a, std::size_t stride, std::size_t size, std::uint32_t* swept, double* work) {
  const LowerTriangle matrix{a, stride, size};
  double* first = work;
  double* second = first + size;
  std::fill_n(swept, size, 0U);
  for (std::size_t left = size; left > 0;) {
    const std::size_t p = take_pivot(size, swept, [&](std::size_t i) { return matrix.diagonal(i); });
    matrix.copy_column(p, first);
    const double d = 1 / first[p];
    if (!std::isfinite(d)) return false;
    if (--left == 0) {
      sweep(matrix, p, d, first);
      break;
    }
    const std::size_t q =
        take_pivot(size, swept, [&](std::size_t i) { return matrix.diagonal(i) - first[i] * first[i] * d; });
    --left;
    // Column q as the first sweep leaves it.
    matrix.copy_column(q, second);
    const double across = d * first[q];
    for (std::size_t i = 0; i < size; ++i)
      second[i] -= across * first[i];
    const double f = 1 / second[q];
    if (!std::isfinite(f)) return false;
    sweep_both(matrix, {p, d, first, second + size}, {q, f, second, second + 2 * size}, across);
  }
  return true;
}

}  // namespace

bool Interpolation::rebuild() {
  ++rebuilds_;
  updates_ = 0;
  put_base();
  double* lengths = work_.data();
  double mean = 0;
  if (!measure_offsets(lengths, mean)) return false;
  assemble_system(lengths, mean);
  const std::size_t count = n_ + size_ - 1;
  if (!invert_system(count)) return false;
  const double* inverse = work_square_.data();
  if (!(residual(count) < good_inverse)) {
    if (!refine(count)) return false;
    inverse = matrix_.data();
  }
  restore_units(inverse, lengths, mean);
  complete_best_row();
  return true;
}

// Lengths of all offsets and their geometric mean without the best point's; false when the points cannot be poised.
bool Interpolation::measure_offsets(double* lengths, double& mean) const {
  double sum = 0;
  for (std::size_t j = 0; j < size_; ++j) {
    lengths[j] = norm(offset(j), n_);
    if (j == best_) continue;
    if (!(lengths[j] > 0) || !std::isfinite(lengths[j])) return false;
    sum += std::log(lengths[j]);
  }
  if (size_ < n_ + 1) return false;
  mean = std::exp(sum / static_cast<double>(size_ - 1));
  return true;
}

// Puts into matrix_ the system of the points other than the best, whose value is the constant; lengths divided out:
// lambda_j |s_j|^2 and g / mean are its unknowns. inverse_ is free until the end: here it has the directions.
void Interpolation::assemble_system(const double* lengths, double mean) {
  double* matrix = matrix_.data();
  double* directions = inverse_.data();
  for (std::size_t i = 0; i < n_; ++i)
    std::fill_n(matrix + i * stride_, n_, 0.0);
  for (std::size_t j = 0; j < size_; ++j) {
    if (j == best_) continue;
    for (std::size_t i = 0; i < n_; ++i) {
      const double part = offset(j)[i] / lengths[j];
      directions[other(j) * n_ + i] = part;
      matrix[(n_ + other(j)) * stride_ + i] = matrix[i * stride_ + n_ + other(j)] = part * (mean / lengths[j]);
    }
  }
  for (std::size_t j = 0; j + 1 < size_; ++j) {
    double* row = matrix + (n_ + j) * stride_ + n_;
    multiply(directions, n_, j + 1, n_, directions + j * n_, row);
    for (std::size_t k = 0; k <= j; ++k)
      row[k] = matrix[(n_ + k) * stride_ + n_ + j] = 0.5 * row[k] * row[k];
  }
}

// The inverse of matrix_ into work_square_; false when there is none.
bool Interpolation::invert_system(std::size_t count) {
  double* inverse = work_square_.data();
  for (std::size_t i = 0; i < count; ++i)
    std::copy_n(matrix_.data() + i * stride_, count, inverse + i * stride_);
  if (!invert_symmetric(inverse, stride_, count, order_.data(), inverse_.data())) return false;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k <= i; ++k)
      inverse[k * stride_ + i] = inverse[i * stride_ + k] = -inverse[i * stride_ + k];
  }
  return true;
}

// Largest entry of W (H v) - v for a few vectors v, W being in matrix_ and H in work_square_.
double Interpolation::residual(std::size_t count) {
  double* v = work_.data() + stride_;
  double* image = v + stride_;
  double* back = image + stride_;
  double worst = 0;
  for (const std::size_t period : {std::size_t{2}, std::size_t{3}}) {
    for (std::size_t i = 0; i < count; ++i)
      v[i] = i % period == 0 ? 1 : -0.5;
    multiply(work_square_.data(), stride_, count, count, v, image);
    multiply(matrix_.data(), stride_, count, count, image, back);
    for (std::size_t i = 0; i < count; ++i) {
      const double away = std::abs(back[i] - v[i]);
      worst = away <= worst ? worst : away;  // or not a number
    }
  }
  return worst;
}

// One step of Newton's iteration for the inverse, H + H (I - W H), into matrix_; false when H was no inverse. inverse_
// is still free.
bool Interpolation::refine(std::size_t count) {
  double* matrix = matrix_.data();
  const double* inverse = work_square_.data();
  double worst = 0;
  for (std::size_t i = 0; i < count; ++i)
    std::fill_n(inverse_row(i), count, 0.0);
  add_product(inverse_.data(), -1, matrix, inverse, stride_, count, count, count);
  for (std::size_t i = 0; i < count; ++i) {
    double* row = inverse_row(i);
    row[i] += 1;
    for (std::size_t k = 0; k < count; ++k)
      worst = std::max(worst, std::abs(row[k]));
  }
  if (!(worst < 1e-3)) return false;
  for (std::size_t i = 0; i < count; ++i)
    std::copy_n(inverse + i * stride_, count, matrix + i * stride_);
  add_product(matrix, 1, inverse, inverse_.data(), stride_, count, count, count);
  return true;
}

// From the inverse of the system to inverse_, in full size and units, but for the best point's row.
void Interpolation::restore_units(const double* inverse, const double* lengths, double mean) {
  double* unit = work_.data() + stride_;
  std::fill_n(unit, n_, mean);
  for (std::size_t j = 0; j < size_; ++j) {
    if (j != best_) unit[n_ + other(j)] = 1 / (lengths[j] * lengths[j]);
  }
  const std::size_t count = n_ + size_ - 1, best_row = n_ + best_;
  const auto wide = [&](std::size_t row) { return row < best_row ? row : row + 1; };
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      const double entry = 0.5 * (inverse[i * stride_ + k] + inverse[k * stride_ + i]) * unit[i] * unit[k];
      inverse_row(wide(i))[wide(k)] = inverse_row(wide(k))[wide(i)] = entry;
    }
  }
}

// The Lagrange function of the best point is 1 minus the others.
void Interpolation::complete_best_row() {
  const std::size_t full = n_ + size_, best_row = n_ + best_;
  for (std::size_t i = 0; i < full; ++i)
    inverse_row(best_row)[i] = inverse_row(i)[best_row] = 0;
  double* ones = work_.data();
  double* sums = work_.data() + 2 * stride_;
  std::fill_n(ones, n_, 0.0);
  std::fill_n(ones + n_, size_, 1.0);
  multiply_symmetric(inverse_.data(), stride_, full, ones, sums);
  sums[best_row] = -dot(sums + n_, ones + n_, size_);
  for (std::size_t i = 0; i < full; ++i)
    inverse_row(best_row)[i] = inverse_row(i)[best_row] = -sums[i];
}

}  // namespace orbicube::trust_region
