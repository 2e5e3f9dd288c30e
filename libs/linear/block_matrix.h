// Sparse symmetric matrices of square blocks, one row of blocks for each node, followed by rows of single unknowns that
// several nodes share.
#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>

#include "base/host.h"
#include "linear/types.h"

namespace orbicube::linear {

// `block` is the number of unknowns of a node: 1, 2 or 3. Vectors have that many entries for each node, then one for
// each shared unknown. An entry of a node that is not an unknown of its own has nothing but its diagonal in row and
// column. Only the lower half is stored.
template <int block>
struct BlockMatrix {
  static constexpr std::size_t unknowns = block;
  using Block = Eigen::Matrix<double, block, block>;
  using Entry = Eigen::Matrix<double, block, 1>;

  explicit BlockMatrix(std::pmr::memory_resource* memory)
      : row_begin(memory),
        column(memory),
        diagonal(memory),
        lower(memory),
        own(memory),
        border_begin(memory),
        border_column(memory),
        border(memory),
        corner_begin(memory),
        corner_column(memory),
        corner(memory),
        corner_diagonal(memory) {}

  std::size_t rows() const { return diagonal.size(); }
  std::size_t shared() const { return corner_diagonal.size(); }
  std::size_t size() const { return unknowns * rows() + shared(); }
  bool is_own(std::size_t row, std::size_t axis) const { return (own[row] >> axis & 1) != 0; }

  // y = A x. Reports to the host.
  void multiply(std::span<const double> x, std::span<double> y, const base::Host& host) const;

  Array<Index> row_begin, column;  // of the blocks below the diagonal, by rows, columns ascending
  Array<Block> diagonal, lower;
  Array<std::uint8_t> own;  // of each row: bit `axis` for an entry that is an unknown of its own
  // Shared unknowns: against the entries of nodes, against earlier shared ones, and against itself.
  Array<Index> border_begin, border_column;
  Array<Entry> border;
  Array<Index> corner_begin, corner_column;
  Array<double> corner, corner_diagonal;
};

// Sorts pairs of row and column, removes duplicates, and sets where the columns of each row begin.
void make_rows(Array<std::pair<Index, Index>>& places, std::size_t rows, Array<Index>& begin, Array<Index>& columns);

extern template struct BlockMatrix<1>;
extern template struct BlockMatrix<2>;
extern template struct BlockMatrix<3>;

}  // namespace orbicube::linear
