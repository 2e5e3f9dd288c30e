// Sparse factor L D L' of A_F A_F' + shift I, where F is a changing set of free unknowns. The elimination order and the
// pattern of L are those of the full A A', found once; a factorization then allocates nothing. Rows that depend on
// earlier ones (redundant rows, or rows whose unknowns are all at bounds) get a zero pivot and a zero multiplier.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

#include "base/array.h"
#include "projected_gradient/sparse_rows.h"

namespace orbicube::projected_gradient {

class NormalFactor {
 public:
  NormalFactor(const SparseRows& rows, std::pmr::memory_resource* memory);

  // Time: the sum over the rows of L of the lengths of the rows that they refer to.
  void factor(const SparseRows& rows, std::span<const std::uint8_t> free, double shift);
  // x <- (A_F A_F' + shift I)^-1 x, in place; m entries. Components along dropped rows become 0.
  void solve(std::span<double> x) const;

 private:
  base::Array<std::uint32_t> order_, position_;  // order_[k]: the row eliminated k-th; position_ its inverse
  base::Array<std::size_t> start_;               // rows of L, strictly lower part, columns ascending
  base::Array<std::uint32_t> column_;
  base::Array<double> value_, inverse_pivot_, work_;
  mutable base::Array<double> permuted_;
};

}  // namespace orbicube::projected_gradient
