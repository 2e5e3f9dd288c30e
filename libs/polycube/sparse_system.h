// Symmetric positive definite systems whose pattern stays while values change.
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>

#include "polycube/surface_map.h"
#ifdef ORBICUBE_POLYCUBE_CHOLMOD
#include "polycube/cholmod_factor.h"
#endif

namespace orbicube::polycube {

// Entries of the lower triangle are declared first, then found by their places.
class SparseSystem {
 public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
  using Triplets = std::pmr::vector<Eigen::Triplet<double, int>>;

  // The pattern is that of `triplets`, each with row >= column, and the whole diagonal.
  SparseSystem(std::size_t size, Triplets& triplets) : matrix_(static_cast<int>(size), static_cast<int>(size)) {
    for (int i = 0; i < static_cast<int>(size); ++i)
      triplets.emplace_back(i, i, 0.0);
    matrix_.setFromTriplets(triplets.begin(), triplets.end());
    matrix_.makeCompressed();
    solver_.analyzePattern(matrix_);
  }

  std::size_t place(Index row, Index column) const {
    const int* const begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
    const int* const end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
    return static_cast<std::size_t>(std::lower_bound(begin, end, static_cast<int>(row)) - matrix_.innerIndexPtr());
  }
  double* values() { return matrix_.valuePtr(); }
  std::size_t value_count() const { return static_cast<std::size_t>(matrix_.nonZeros()); }

  // Whether the matrix as it is could be factorised.
  bool factorize() {
    solver_.factorize(matrix_);
    return solver_.info() == Eigen::Success;
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& right) const { return solver_.solve(right); }

 private:
#ifdef ORBICUBE_POLYCUBE_CHOLMOD
  using Factor = CholmodFactor;
#else
  using Factor = Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::AMDOrdering<int>>;
#endif

  Matrix matrix_;
  Factor solver_;
};

}  // namespace orbicube::polycube
