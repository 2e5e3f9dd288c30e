// Dense least squares by Householder QR with column pivoting (Businger and Golub 1965), which shows the rank: the
// solution of minimum squares, of minimum length among them when the columns are dependent.
#pragma once

#include <cstddef>
#include <span>

#include "base/array.h"
#include "base/host.h"

namespace orbicube::harmonics {

struct DenseSolution {
  std::size_t rank = 0;
  double condition = 0;  // estimate: the largest over the smallest diagonal entry of R within the rank
};

// Minimizes |A x - b| for `right_sides` columns b. A (rows x columns, by columns) and b (rows x right_sides, by
// columns) are overwritten; x is columns x right_sides, by columns. Diagonal entries of R below max(rows, columns) *
// epsilon of the first count as zero. O(rows columns^2).
DenseSolution solve_dense(std::span<double> a, std::size_t rows, std::size_t columns, std::span<double> b,
                          std::size_t right_sides, std::span<double> x, const base::Host& host);

}  // namespace orbicube::harmonics
