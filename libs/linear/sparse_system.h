// Symmetric positive definite systems whose pattern stays while values change.
#pragma once

#include <Eigen/Core>

#include "linear/direct/direct_factor.h"

namespace orbicube::linear {

// Entries of the lower triangle are declared first, then found by row and column.
class SparseSystem {
 public:
  using Triplets = linear::Triplets;

  // The pattern is that of `triplets`, each with row >= column, and the whole diagonal.
  SparseSystem(std::size_t size, Triplets& triplets, DirectMethod method = DirectMethod::automatic);

  std::size_t place(Index row, Index column) const;
  double* values() { return matrix_.valuePtr(); }
  std::size_t value_count() const { return static_cast<std::size_t>(matrix_.nonZeros()); }
  const SparseMatrix& matrix() const { return matrix_; }

  // Returns whether there is a factor.
  bool factorize() { return factor_->factorize(matrix_); }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

 private:
  SparseMatrix matrix_;
  std::unique_ptr<DirectFactor> factor_;
};

}  // namespace orbicube::linear
