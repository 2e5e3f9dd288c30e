// Orthogonal reduction of a symmetric matrix to tridiagonal form (Golub and Van Loan, Matrix Computations, section
// 8.3.1), and its eigenvalues and eigenvectors by implicit symmetric QR steps (section 8.3.3).
#pragma once

#include <cstddef>
#include <memory_resource>

#include "base/array.h"

namespace orbicube::trust_region {

// A = Q T Q' with Q a product of reflectors.
class Tridiagonal {
 public:
  Tridiagonal(std::size_t capacity, std::pmr::memory_resource* memory);

  // The matrix to reduce, size x size by rows, is put here first; reduce() leaves the reflectors in its place.
  double* matrix() { return matrix_.data(); }
  void reduce(std::size_t size);

  const double* diagonal() const { return diagonal_.data(); }
  const double* below() const { return below_.data(); }  // size - 1 entries beside the diagonal
  void to_reduced(double* x) const;                      // x = Q'x
  void from_reduced(double* x) const;                    // x = Q x

  // Of the matrix put into matrix(): eigenvalues (size, in no order), and its eigenvectors as the rows of `vectors`
  // (size x size; null: not requested). False when the iteration does not end, as with numbers that are not finite.
  bool eigen(std::size_t size, double* values, double* vectors);

 private:
  std::size_t size_ = 0;
  base::Array<double> matrix_;  // capacity x capacity
  base::Array<double> diagonal_, below_, factor_, work_;
};

}  // namespace orbicube::trust_region
