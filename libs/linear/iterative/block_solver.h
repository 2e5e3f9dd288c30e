// Iterative solution of systems with block matrices: by Gauss-Seidel with conjugate gradients, by multigrid where there
// are many rows, or by another program's engine.
#pragma once

#include "linear/iterative/block_engine.h"
#include "linear/iterative/multigrid.h"

namespace orbicube::linear {

enum class IterativeMethod;  // iterative_solver.h

template <int block>
class BlockSolver {
 public:
  using Matrix = BlockMatrix<block>;

  explicit BlockSolver(const base::Host& host);
  BlockSolver(const base::Host& host, IterativeMethod method);

  // The engine that solves from now on; none: this library's own.
  void set_engine(BlockEngine<block>* engine) { engine_ = engine; }
  // Keeps a view of the matrix, and adds a little to its diagonal.
  void factor(Matrix& matrix);
  // As GaussSeidel::solve.
  int solve(std::span<const double> right, int max_steps, double tolerance, std::span<double> solution);

 private:
  bool by_multigrid() const { return matrix_->rows() >= multigrid_from_; }

  const base::Host& host_;
  std::size_t multigrid_from_;  // rows
  BlockEngine<block>* engine_ = nullptr;
  Matrix* matrix_ = nullptr;
  GaussSeidel<block> gauss_seidel_;
  Multigrid<block> multigrid_;
};

extern template class BlockSolver<1>;
extern template class BlockSolver<2>;
extern template class BlockSolver<3>;

}  // namespace orbicube::linear
