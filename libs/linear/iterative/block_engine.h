// Another program's solver of the linear systems, in place of the library's own (gauss_seidel.h, multigrid.h).
#pragma once

#include <span>

#include "linear/block_matrix.h"

namespace orbicube::linear {

template <int block>
class BlockEngine {
 public:
  virtual ~BlockEngine() = default;

  // `solution` is that of the step at which the residual, measured by the engine's preconditioner, is `tolerance` of
  // what it was, or of the last step. Returns the number of steps. Throws Error "no-valid-result" when the engine
  // fails, "cancelled".
  virtual int solve(const BlockMatrix<block>& matrix, std::span<const double> right, int max_steps, double tolerance,
                    std::span<double> solution, const base::Host& host) = 0;
};

}  // namespace orbicube::linear
