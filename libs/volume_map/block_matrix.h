// Sparse symmetric matrices of maps of tetrahedra: a row of 3 x 3 blocks a vertex, then a row of numbers for each
// unknown that several coordinates share.
#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>

#include "base/team.h"
#include "volume_map/elements.h"

namespace orbicube::volume_map {

// Vectors have three entries a row of blocks, then one a shared unknown. Rows and columns of coordinates that are no
// unknowns of their own have but an entry on the diagonal. Of the rest the lower half is kept.
struct BlockMatrix {
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
  std::size_t size() const { return 3 * rows() + shared(); }
  bool is_own(std::size_t row, std::size_t axis) const { return (own[row] >> axis & 1) != 0; }

  // y = A x. Reports to the host.
  void multiply(std::span<const double> x, std::span<double> y, const base::Host& host) const;

  Array<Index> row_begin, column;  // of the blocks below the diagonal, by rows, columns ascending
  Array<Eigen::Matrix3d> diagonal, lower;
  Array<std::uint8_t> own;  // of each row: bit `axis` for a coordinate that is an unknown of its own
  // Shared unknowns: against the coordinates of vertices, against shared ones before, and against itself.
  Array<Index> border_begin, border_column;
  Array<Vector3> border;
  Array<Index> corner_begin, corner_column;
  Array<double> corner, corner_diagonal;
};

// Where rows of columns begin, and their columns, from pairs of both, which are sorted and made different.
void make_rows(Array<std::pair<Index, Index>>& places, std::size_t rows, Array<Index>& begin, Array<Index>& columns);

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
  void finish(const base::Team& team);

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

}  // namespace orbicube::volume_map
