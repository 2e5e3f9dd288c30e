#include "linear/iterative/iterative_solver.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "linear/iterative/block_solver.h"

namespace orbicube::linear {
namespace {

double norm(std::span<const double> x) {
  double sum = 0;
  for (const double entry : x)
    sum += entry * entry;
  return std::sqrt(sum);
}

// The exponent of the largest entry, by which vectors are scaled so that their squares stay in range.
int exponent_of(std::span<const double> x) {
  double largest = 0;
  for (const double entry : x)
    largest = std::max(largest, std::abs(entry));
  return largest > 0 ? std::ilogb(largest) : 0;
}

template <int block>
class Solver : public IterativeSolver {
 public:
  Solver(const SymmetricMatrix& matrix, IterativeMethod method, const base::Host& host)
      : host_(host),
        matrix_(in_blocks<block>(matrix, host)),
        regular_(matrix_),
        solver_(host, method),
        right_(host.memory),
        residual_(host.memory),
        correction_(host.memory),
        image_(host.memory) {
    solver_.factor(regular_);
  }

  std::size_t size() const override { return matrix_.size(); }

  IterativeReport solve(std::span<const double> right, const IterativeOptions& options,
                        std::span<double> solution) override {
    // One run of conjugate gradients gains little more: its own residual drifts from that of the matrix.
    constexpr double min_gain_of_a_run = 1e-6, stalled = 0.5;
    IterativeReport report;
    host_.report("solve", 0, 0);
    const int exponent = exponent_of(right);
    right_.resize(right.size());
    for (std::size_t i = 0; i < right.size(); ++i)
      right_[i] = std::ldexp(right[i], -exponent);
    residual_ = right_;
    correction_.resize(right.size());
    image_.resize(right.size());
    std::fill(solution.begin(), solution.end(), 0.0);
    const double size = norm(right_);
    report.residual = size > 0 ? 1 : 0;
    for (double before = size; size > 0;) {
      if (before <= options.tolerance * size || report.iterations >= options.max_iterations) break;
      const double gain = std::max(min_gain_of_a_run, 0.3 * options.tolerance * size / before);
      report.iterations += solver_.solve(residual_, options.max_iterations - report.iterations, gain, correction_);
      for (std::size_t i = 0; i < solution.size(); ++i)
        solution[i] += correction_[i];
      matrix_.multiply(solution, image_, host_);
      for (std::size_t i = 0; i < right.size(); ++i)
        residual_[i] = right_[i] - image_[i];
      const double now = norm(residual_);
      report.residual = now / size;
      const bool worse = !(now <= stalled * before);
      before = now;
      if (worse) break;
    }
    for (double& entry : solution)
      entry = std::ldexp(entry, exponent);
    report.converged = report.residual <= options.tolerance;
    return report;
  }

 private:
  const base::Host& host_;
  const BlockMatrix<block> matrix_;
  BlockMatrix<block> regular_;  // with a little added to the diagonal
  BlockSolver<block> solver_;
  Array<double> right_, residual_, correction_, image_;  // scaled
};

}  // namespace

template <int block>
std::unique_ptr<IterativeSolver> make_block_solver(const SymmetricMatrix& matrix, IterativeMethod method,
                                                   const base::Host& host) {
  base::require(matrix.size() % std::size_t{block} == 0, "the size is no multiple of the block size");
  return std::make_unique<Solver<block>>(matrix, method, host);
}

template std::unique_ptr<IterativeSolver> make_block_solver<1>(const SymmetricMatrix&, IterativeMethod,
                                                               const base::Host&);
template std::unique_ptr<IterativeSolver> make_block_solver<2>(const SymmetricMatrix&, IterativeMethod,
                                                               const base::Host&);
template std::unique_ptr<IterativeSolver> make_block_solver<3>(const SymmetricMatrix&, IterativeMethod,
                                                               const base::Host&);

std::unique_ptr<IterativeSolver> make_iterative_solver(const SymmetricMatrix& matrix, int block, IterativeMethod method,
                                                       const base::Host& host) {
  base::require(block >= 1 && block <= 3, "the block size must be 1, 2 or 3");
  if (block == 1) return make_block_solver<1>(matrix, method, host);
  return block == 2 ? make_block_solver<2>(matrix, method, host) : make_block_solver<3>(matrix, method, host);
}

}  // namespace orbicube::linear
