// The linear systems of maps: by Gauss-Seidel with conjugate gradients, by multigrid where there are many rows, or by
// another program's engine.
#pragma once

#include "volume_map/linear_engine.h"
#include "volume_map/multigrid.h"

namespace orbicube::volume_map {

class LinearSolver {
 public:
  explicit LinearSolver(const base::Host& host) : host_(host), gauss_seidel_(host), multigrid_(host) {}

  // That solves from now on; none: this library's own.
  void set_engine(LinearEngine* engine) { engine_ = engine; }
  // Keeps a view of the matrix, and adds a little to its diagonal.
  void factor(BlockMatrix& matrix);
  // As GaussSeidel::solve.
  int solve(std::span<const double> right, int most_steps, double tolerance, std::span<double> solution);

 private:
  const base::Host& host_;
  LinearEngine* engine_ = nullptr;
  BlockMatrix* matrix_ = nullptr;
  GaussSeidel gauss_seidel_;
  Multigrid multigrid_;
};

}  // namespace orbicube::volume_map
