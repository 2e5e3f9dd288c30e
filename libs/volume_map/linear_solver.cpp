#include "volume_map/linear_solver.h"

namespace orbicube::volume_map {
namespace {

// Steps of multigrid cost some four times those of Gauss-Seidel, of which more are made the more rows there are.
constexpr std::size_t large_rows = 20000;

}  // namespace

void LinearSolver::factor(BlockMatrix& matrix) {
  matrix_ = &matrix;
  if (engine_ == nullptr && matrix.rows() >= large_rows)
    multigrid_.factor(matrix);
  else
    gauss_seidel_.factor(matrix);
}

int LinearSolver::solve(std::span<const double> right, int most_steps, double tolerance, std::span<double> solution) {
  if (engine_ != nullptr) return engine_->solve(*matrix_, right, most_steps, tolerance, solution, host_);
  if (matrix_->rows() >= large_rows) return multigrid_.solve(right, most_steps, tolerance, solution);
  return gauss_seidel_.solve(right, most_steps, tolerance, solution);
}

}  // namespace orbicube::volume_map
