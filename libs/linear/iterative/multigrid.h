// Algebraic multigrid for large matrices of blocks, so that the number of steps hardly grows with them: aggregates of
// about eight vertices, in which corrections are constant, sweeps of Gauss-Seidel, and two steps of conjugate gradients
// at each coarse level (Notay 2010, "An aggregation-based algebraic multigrid method"; Notay and Vassilevski 2008,
// "Recursive Krylov-based multigrid cycles").
#pragma once

#include <memory>
#include <vector>

#include "linear/iterative/gauss_seidel.h"

namespace orbicube::linear {

template <int block>
class Multigrid {
 public:
  using Matrix = BlockMatrix<block>;

  explicit Multigrid(const base::Host& host) : host_(host), last_(host.memory) {}

  // Makes the levels. Keeps a view of the matrix, and adds a little to its diagonal.
  void factor(Matrix& matrix);
  // As GaussSeidel::solve.
  int solve(std::span<const double> right, int max_steps, double tolerance, std::span<double> solution);

  std::size_t levels() const { return depth_; }

 private:
  struct Level {
    explicit Level(const base::Host& host)
        : coarse(host.memory),
          smoother(host),
          aggregate(host.memory),
          right(host.memory),
          solution(host.memory),
          residual(host.memory),
          first(host.memory),
          second(host.memory),
          first_image(host.memory),
          second_image(host.memory) {}

    Matrix coarse;             // the first level has the matrix of its user
    Matrix* matrix = nullptr;  // that of this level
    GaussSeidel<block> smoother;
    Array<Index> aggregate;  // of each row: the row of the next level, or no_index
    // In the order of use: right side and solution for the next finer level; within a cycle; of the steps.
    Array<double> right, solution, residual, first, second, first_image, second_image;
  };

  void factor_last();
  void cycle(std::size_t level, std::span<const double> right, std::span<double> x);
  // Solves for the right side of that level, roughly.
  void solve_level(std::size_t level);

  const base::Host& host_;
  std::vector<std::unique_ptr<Level>> levels_;  // more than there are at times: their memory is used again
  std::size_t depth_ = 0;
  Array<double> last_;  // Cholesky factor of the coarsest matrix, by rows; empty where there is none
};

extern template class Multigrid<1>;
extern template class Multigrid<2>;
extern template class Multigrid<3>;

}  // namespace orbicube::linear
