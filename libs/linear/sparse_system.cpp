#include "linear/sparse_system.h"

#include <algorithm>

namespace orbicube::linear {

SparseSystem::SparseSystem(std::size_t size, Triplets& triplets, DirectMethod method)
    : matrix_(static_cast<int>(size), static_cast<int>(size)), factor_(make_direct_factor(method)) {
  for (int i = 0; i < static_cast<int>(size); ++i)
    triplets.emplace_back(i, i, 0.0);
  matrix_.setFromTriplets(triplets.begin(), triplets.end());
  matrix_.makeCompressed();
  factor_->analyze(matrix_);
}

std::size_t SparseSystem::place(Index row, Index column) const {
  const int* const begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
  const int* const end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
  return static_cast<std::size_t>(std::lower_bound(begin, end, static_cast<int>(row)) - matrix_.innerIndexPtr());
}

Eigen::VectorXd SparseSystem::solve(const Eigen::VectorXd& right) const {
  Eigen::VectorXd solution(right.size());
  const auto size = static_cast<std::size_t>(right.size());
  factor_->solve({right.data(), size}, 1, {solution.data(), size});
  return solution;
}

}  // namespace orbicube::linear
