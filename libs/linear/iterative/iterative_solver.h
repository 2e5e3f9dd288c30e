// Iterative solution of sparse symmetric positive definite systems to a given residual.
#pragma once

#include <memory>
#include <span>

#include "base/host.h"
#include "linear/symmetric_matrix.h"

namespace orbicube::linear {

enum class IterativeMethod { automatic, gauss_seidel, multigrid };

struct IterativeOptions {
  double tolerance = 1e-8;  // of |b - A x| relative to |b|
  int max_iterations = 1000;
};

struct IterativeReport {
  int iterations = 0;
  double residual = 0;  // |b - A x| / |b|
  bool converged = false;
};

class IterativeSolver {
 public:
  virtual ~IterativeSolver() = default;
  // Conjugate gradients from zero, restarted on the residual of the matrix itself until that is small enough, the
  // iterations are used up, or rounding allows no more. Throws Error "cancelled".
  virtual IterativeReport solve(std::span<const double> right, const IterativeOptions& options,
                                std::span<double> solution) = 0;
  virtual std::size_t size() const = 0;
};

// Copies the matrix. `block` is 1, 2 or 3, the number of consecutive unknowns that belong together, as x y z of a
// point. `automatic` is multigrid from 20,000 blocks on. The host must outlive the solver.
std::unique_ptr<IterativeSolver> make_iterative_solver(const SymmetricMatrix& matrix, int block, IterativeMethod method,
                                                       const base::Host& host);

// The same for a block size that is known, so that a program that needs one contains one.
template <int block>
std::unique_ptr<IterativeSolver> make_block_solver(const SymmetricMatrix& matrix, IterativeMethod method,
                                                   const base::Host& host);

extern template std::unique_ptr<IterativeSolver> make_block_solver<1>(const SymmetricMatrix&, IterativeMethod,
                                                                      const base::Host&);
extern template std::unique_ptr<IterativeSolver> make_block_solver<2>(const SymmetricMatrix&, IterativeMethod,
                                                                      const base::Host&);
extern template std::unique_ptr<IterativeSolver> make_block_solver<3>(const SymmetricMatrix&, IterativeMethod,
                                                                      const base::Host&);

}  // namespace orbicube::linear
