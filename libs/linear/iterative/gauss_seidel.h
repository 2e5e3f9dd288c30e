// Gauss-Seidel sweeps over matrices of blocks, and conjugate gradients preconditioned by a sweep there and back at the
// cost of one product a step (Eisenstat 1981, "Efficient implementation of a class of preconditioned conjugate gradient
// methods").
#pragma once

#include "linear/block_matrix.h"

namespace orbicube::linear {

template <int block>
class GaussSeidel {
 public:
  using Matrix = BlockMatrix<block>;

  explicit GaussSeidel(const base::Host& host)
      : host_(host),
        inverse_(host.memory),
        residual_(host.memory),
        search_(host.memory),
        image_(host.memory),
        product_(host.memory) {}

  // Keeps a view of the matrix, to whose diagonal it adds a little, more where a block is singular.
  void factor(Matrix& matrix);

  void forward(std::span<double> x) const;   // x becomes (D + L)^-1 x
  void backward(std::span<double> x) const;  // x becomes (D + L')^-1 x

  // A sweep that starts at 0: x = (D + L)^-1 right, and what is left of the right side.
  void sweep_from_zero(std::span<const double> right, std::span<double> x, std::span<double> residual) const;
  // A sweep from the last row to the first. `sums` is for its own use.
  void sweep_back(std::span<const double> right, std::span<double> x, std::span<double> sums) const;

  // `solution` begins at 0, and is that of the step at which the residual, measured by the preconditioner, is
  // `tolerance` of what it was, or of the last step. Returns the number of steps. Reports to the host.
  int solve(std::span<const double> right, int max_steps, double tolerance, std::span<double> solution);

 private:
  void sweep_row(std::size_t v, std::span<const double> right, std::span<double> x, std::span<double> sums) const;
  void sweep_shared(std::size_t s, std::span<const double> right, std::span<double> x, std::span<double> sums) const;
  void multiply_diagonal(std::span<const double> x, std::span<double> y) const;

  using Entry = typename Matrix::Entry;

  const base::Host& host_;
  const Matrix* matrix_ = nullptr;
  Array<typename Matrix::Block> inverse_;
  Array<double> residual_, search_, image_, product_;
};

extern template class GaussSeidel<1>;
extern template class GaussSeidel<2>;
extern template class GaussSeidel<3>;

}  // namespace orbicube::linear
