#include "linear/iterative/block_solver.h"

#include "linear/iterative/iterative_solver.h"

namespace orbicube::linear {
namespace {

// Steps of multigrid cost some four times those of Gauss-Seidel, of which more are made the more rows there are.
constexpr std::size_t many_rows = 20000;

std::size_t multigrid_rows(IterativeMethod method) {
  if (method == IterativeMethod::gauss_seidel) return static_cast<std::size_t>(-1);
  return method == IterativeMethod::multigrid ? 0 : many_rows;
}

}  // namespace

template <int block>
BlockSolver<block>::BlockSolver(const base::Host& host) : BlockSolver(host, IterativeMethod::automatic) {}

template <int block>
BlockSolver<block>::BlockSolver(const base::Host& host, IterativeMethod method)
    : host_(host), multigrid_from_(multigrid_rows(method)), gauss_seidel_(host), multigrid_(host) {}

template <int block>
void BlockSolver<block>::factor(Matrix& matrix) {
  matrix_ = &matrix;
  if (engine_ == nullptr && by_multigrid())
    multigrid_.factor(matrix);
  else
    gauss_seidel_.factor(matrix);
}

template <int block>
int BlockSolver<block>::solve(std::span<const double> right, int max_steps, double tolerance,
                              std::span<double> solution) {
  if (engine_ != nullptr) return engine_->solve(*matrix_, right, max_steps, tolerance, solution, host_);
  if (by_multigrid()) return multigrid_.solve(right, max_steps, tolerance, solution);
  return gauss_seidel_.solve(right, max_steps, tolerance, solution);
}

template class BlockSolver<1>;
template class BlockSolver<2>;
template class BlockSolver<3>;

}  // namespace orbicube::linear
