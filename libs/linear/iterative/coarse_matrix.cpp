#include "linear/iterative/coarse_matrix.h"

#include <Eigen/Dense>
#include <algorithm>

namespace orbicube::linear {
namespace {

Index find(const Array<Index>& begin, const Array<Index>& columns, Index row, Index column) {
  const auto first = columns.begin() + static_cast<std::ptrdiff_t>(begin[row]);
  const auto last = columns.begin() + static_cast<std::ptrdiff_t>(begin[row + 1]);
  return static_cast<Index>(std::lower_bound(first, last, column) - columns.begin());
}

// The places of blocks off the diagonal. `places` is for its own use.
template <int block>
void make_pattern(const BlockMatrix<block>& m, const Array<Index>& to, Array<std::pair<Index, Index>>& places,
                  BlockMatrix<block>& coarse, const base::Host& host) {
  for (std::size_t v = 0; v < m.rows(); ++v) {
    if (v % base::items_between_reports == 0) host.report("solve", 0, 0);
    for (Index i = m.row_begin[v]; i < m.row_begin[v + 1]; ++i) {
      const Index a = to[v], b = to[m.column[i]];
      if (a != b && a != no_index && b != no_index) places.push_back({std::max(a, b), std::min(a, b)});
    }
  }
  host.report("solve", 0, 0);
  make_rows(places, coarse.own.size(), coarse.row_begin, coarse.column);
  host.report("solve", 0, 0);
}

template <int block>
void add_blocks(const BlockMatrix<block>& m, const Array<Index>& to, BlockMatrix<block>& coarse,
                const base::Host& host) {
  using Block = typename BlockMatrix<block>::Block;
  coarse.lower.assign(coarse.column.size(), Block::Zero());
  coarse.diagonal.assign(coarse.own.size(), Block::Zero());
  for (std::size_t v = 0; v < m.rows(); ++v) {
    if (v % base::items_between_reports == 0) host.report("solve", 0, 0);
    const Index a = to[v];
    if (a == no_index) continue;
    for (Eigen::Index r = 0; r < block; ++r) {
      for (Eigen::Index c = 0; c < block; ++c) {
        if (m.is_own(v, static_cast<std::size_t>(r)) && m.is_own(v, static_cast<std::size_t>(c)))
          coarse.diagonal[a](r, c) += m.diagonal[v](r, c);
      }
    }
    for (Index i = m.row_begin[v]; i < m.row_begin[v + 1]; ++i) {
      const Index b = to[m.column[i]];
      if (b == no_index) continue;
      if (a == b)
        coarse.diagonal[a] += m.lower[i] + m.lower[i].transpose();
      else if (a > b)
        coarse.lower[find(coarse.row_begin, coarse.column, a, b)] += m.lower[i];
      else
        coarse.lower[find(coarse.row_begin, coarse.column, b, a)] += m.lower[i].transpose();
    }
  }
}

// Entries that are no unknown get a diagonal of the others' size.
template <int block>
void fill_diagonal(BlockMatrix<block>& coarse) {
  for (std::size_t a = 0; a < coarse.own.size(); ++a) {
    const double trace = coarse.diagonal[a].trace();
    for (std::size_t k = 0; k < BlockMatrix<block>::unknowns; ++k) {
      if (!coarse.is_own(a, k))
        coarse.diagonal[a](static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k)) = trace > 0 ? trace : 1;
    }
  }
}

template <int block>
void copy_shared(const BlockMatrix<block>& m, const Array<Index>& to, Array<std::pair<Index, Index>>& places,
                 BlockMatrix<block>& coarse) {
  places.clear();
  for (Index s = 0; s < m.shared(); ++s) {
    for (Index i = m.border_begin[s]; i < m.border_begin[s + 1]; ++i) {
      if (to[m.border_column[i]] != no_index) places.push_back({s, to[m.border_column[i]]});
    }
  }
  make_rows(places, m.shared(), coarse.border_begin, coarse.border_column);
  coarse.border.assign(coarse.border_column.size(), BlockMatrix<block>::Entry::Zero());
  for (Index s = 0; s < m.shared(); ++s) {
    for (Index i = m.border_begin[s]; i < m.border_begin[s + 1]; ++i) {
      const Index a = to[m.border_column[i]];
      if (a != no_index) coarse.border[find(coarse.border_begin, coarse.border_column, s, a)] += m.border[i];
    }
  }
  coarse.corner_begin = m.corner_begin;
  coarse.corner_column = m.corner_column;
  coarse.corner = m.corner;
  coarse.corner_diagonal = m.corner_diagonal;
}

}  // namespace

template <int block>
void make_coarse(const BlockMatrix<block>& matrix, const Array<Index>& aggregate, std::size_t count,
                 BlockMatrix<block>& coarse, const base::Host& host) {
  coarse.own.assign(count, 0);
  for (std::size_t v = 0; v < matrix.rows(); ++v) {
    if (aggregate[v] != no_index) coarse.own[aggregate[v]] |= matrix.own[v];
  }
  Array<std::pair<Index, Index>> places(host.memory);
  make_pattern(matrix, aggregate, places, coarse, host);
  add_blocks(matrix, aggregate, coarse, host);
  fill_diagonal(coarse);
  copy_shared(matrix, aggregate, places, coarse);
}

template void make_coarse<1>(const BlockMatrix<1>&, const Array<Index>&, std::size_t, BlockMatrix<1>&,
                             const base::Host&);
template void make_coarse<2>(const BlockMatrix<2>&, const Array<Index>&, std::size_t, BlockMatrix<2>&,
                             const base::Host&);
template void make_coarse<3>(const BlockMatrix<3>&, const Array<Index>&, std::size_t, BlockMatrix<3>&,
                             const base::Host&);

}  // namespace orbicube::linear
