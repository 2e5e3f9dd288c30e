// Assembly of the sparse symmetric matrices of maps of tetrahedra: a row of 3 x 3 blocks for each vertex, then a row
// for each unknown that several coordinates share.
#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>

#include "base/threads/thread_pool.h"
#include "linear/iterative/block_solver.h"
#include "untangle/tetrahedra/elements.h"
#include "untangle/untangling.h"

namespace orbicube::untangle {

using BlockMatrix = linear::BlockMatrix<3>;
using BlockSolver = linear::BlockSolver<3>;

// Where elements put their blocks: the pattern of the matrix, made once, and the way from blocks of whole vertices to
// the unknowns.
class BlockAssembly {
 public:
  // Two vertices with free coordinates have a block when an element has both. Keeps a view of the variables.
  BlockAssembly(std::span<const Element> elements, const Variables& variables, const base::Host& host);

  BlockMatrix& matrix() { return matrix_; }
  const BlockMatrix& matrix() const { return matrix_; }
  // Where the block of these corners of an element is in matrix().lower: row of the greater vertex, column of the lower
  // one; no_index where there is none.
  Index place(std::size_t element, std::size_t corner, std::size_t other) const {
    return place_[6 * element + pair[corner][other]];
  }
  // Once the blocks, of all coordinates, are there: sums of rows and columns go to what is shared, and what is no
  // unknown of its own is cleared.
  void finish(const base::ThreadPool& pool);

  // From the free variables to entries of vectors of the matrix, and back. What is no unknown is 0.
  void scatter(std::span<const double> free, std::span<double> entries) const;
  void gather(std::span<const double> entries, std::span<double> free) const;

 private:
  static constexpr std::size_t pair[4][4] = {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}};
  enum class Kind : std::uint8_t { row, column, corner, diagonal, twice };
  // A part of a block that belongs to a shared unknown.
  struct Share {
    Index block;  // in lower, or behind it of the diagonal
    Index place;
    Kind kind;
    std::uint8_t row, column;  // in the block
  };

  void add_places(std::span<const Element> elements, std::span<const std::uint8_t> active, const base::Host& host);
  void add_shares(const base::Host& host);

  const Variables& variables_;
  BlockMatrix matrix_;
  Array<Index> place_;
  Array<Share> shares_;
};

}  // namespace orbicube::untangle
