// Eigen's simplicial factors, with rows that are removed and matrices of rank one that are added.
#pragma once

#include <Eigen/SparseCholesky>

#include "linear/direct/direct_factor.h"

namespace orbicube::linear {

class SimplicialFactor : public DirectFactor {
 public:
  void analyze(const SparseMatrix& matrix) override;
  bool factorize(const SparseMatrix& matrix) override;
  void solve(std::span<const double> right, std::size_t columns, std::span<double> solution) const override;
  void remove_row(Index row) override;
  bool update(std::span<const Index> rows, std::span<const double> values, int sign) override;
  bool is_positive() const override;
  std::size_t entries() const override;

 private:
  using Base = Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<int>>;
  // Gives access to the factors, which Eigen lets be read only.
  struct Factors : Base {
    using Base::m_diag;
    using Base::m_info;
    using Base::m_matrix;
    using Base::m_P;
    using Base::m_parent;
  };

  bool update_along_path(int first, int sign);

  Factors factors_;
  Eigen::VectorXd work_;
};

}  // namespace orbicube::linear
