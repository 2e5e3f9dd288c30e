// A sparse symmetric matrix as a caller has it, and its conversion to what the solvers keep.
#pragma once

#include <span>

#include "base/host.h"
#include "linear/block_matrix.h"

namespace orbicube::linear {

// The lower triangle by rows: columns of each row ascend and end with the diagonal.
struct SymmetricMatrix {
  std::span<const std::size_t> row_begin;  // size + 1
  std::span<const Index> columns;
  std::span<const double> values;

  std::size_t size() const { return row_begin.size() - 1; }
  // y = A x.
  void multiply(std::span<const double> x, std::span<double> y) const;
};

// Throws Error "invalid-argument" with the row that is wrong.
void require_valid(const SymmetricMatrix& matrix);

// The same by columns; place[i] is where entry i of `matrix` went.
SparseMatrix by_columns(const SymmetricMatrix& matrix, Array<int>& place);

// The same in blocks of `block` rows; matrix.size() is a multiple of it.
template <int block>
BlockMatrix<block> in_blocks(const SymmetricMatrix& matrix, const base::Host& host);

extern template BlockMatrix<1> in_blocks<1>(const SymmetricMatrix& matrix, const base::Host& host);
extern template BlockMatrix<2> in_blocks<2>(const SymmetricMatrix& matrix, const base::Host& host);
extern template BlockMatrix<3> in_blocks<3>(const SymmetricMatrix& matrix, const base::Host& host);

}  // namespace orbicube::linear
