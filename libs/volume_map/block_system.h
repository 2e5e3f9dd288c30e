// Sparse symmetric systems whose entries are blocks of 3 x 3, one row a vertex, and conjugate gradients for them with
// symmetric Gauss-Seidel as preconditioner, at the cost of one product a step (Eisenstat 1981, "Efficient
// implementation of a class of preconditioned conjugate gradient methods").
#pragma once

#include <Eigen/Core>
#include <span>

#include "base/team.h"
#include "volume_map/elements.h"

namespace orbicube::volume_map {

class BlockSystem {
 public:
  // Two vertices that are both `active` (an entry a vertex) have a block when an element has both.
  BlockSystem(std::span<const Element> elements, std::span<const std::uint8_t> active, const base::Host& host);

  std::size_t rows() const { return diagonal_.size(); }
  // Where the block of these corners of an element is among off_diagonal(): row of the greater vertex, column of the
  // lower one; no_index where there is none.
  Index place(std::size_t element, std::size_t corner, std::size_t other) const {
    return place_[6 * element + pair[corner][other]];
  }
  std::span<Eigen::Matrix3d> diagonal() { return diagonal_; }
  std::span<Eigen::Matrix3d> off_diagonal() { return lower_; }
  // Of one row, to be cleared before blocks are added up.
  std::span<Eigen::Matrix3d> off_diagonal_of(std::size_t row) {
    return std::span(lower_).subspan(row_begin_[row], row_begin_[row + 1] - row_begin_[row]);
  }
  std::span<const Index> columns_of(std::size_t row) const {
    return std::span(column_).subspan(row_begin_[row], row_begin_[row + 1] - row_begin_[row]);
  }

  // Takes the diagonal as it is now, and adds a little to it.
  void factor();
  // `solution` begins at 0, and is that of the step at which the residual, measured by the preconditioner, is
  // `tolerance` of what it was, or of the last step. Reports to the host.
  void solve(std::span<const Vector3> right, int most_steps, double tolerance, std::span<Vector3> solution);

 private:
  static constexpr std::size_t pair[4][4] = {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}};

  void forward(std::span<Vector3> x) const;   // x becomes (D + L)^-1 x
  void backward(std::span<Vector3> x) const;  // x becomes (D + L')^-1 x

  const base::Host& host_;
  Array<Index> row_begin_;  // of the blocks below the diagonal
  Array<Index> column_;
  Array<Index> place_;
  Array<Eigen::Matrix3d> diagonal_, inverse_, lower_;
  Array<Vector3> residual_, search_, image_, product_;
};

}  // namespace orbicube::volume_map
