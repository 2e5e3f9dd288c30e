#include "untangle/tetrahedra/block_assembly.h"

#include <Eigen/Dense>
#include <algorithm>
#include <tuple>

#include "base/grouping.h"

namespace orbicube::untangle {
namespace {

constexpr std::size_t rows_a_piece = 1024;
// Rows between two reports: some milliseconds.
constexpr std::size_t rows_at_once = 16384;

}  // namespace

BlockAssembly::BlockAssembly(std::span<const Element> elements, const Variables& variables, const base::Host& host)
    : variables_(variables),
      matrix_(host.memory),
      place_(6 * elements.size(), no_index, host.memory),
      shares_(host.memory) {
  const std::size_t vertices = variables.vertices();
  Array<std::uint8_t> active(vertices, 0, host.memory);
  matrix_.own.assign(vertices, 0);
  for (std::size_t v = 0; v < vertices; ++v) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (variables.is_free(v, a)) active[v] = 1;
      if (variables.is_own(v, a)) matrix_.own[v] |= static_cast<std::uint8_t>(1U << a);
    }
  }
  matrix_.diagonal.assign(vertices, Eigen::Matrix3d::Identity());
  add_places(elements, active, host);
  matrix_.lower.assign(matrix_.column.size(), Eigen::Matrix3d::Zero());
  matrix_.border_begin.assign(1, 0);
  matrix_.corner_begin.assign(1, 0);
  if (variables.any_shared()) add_shares(host);
}

void BlockAssembly::add_places(std::span<const Element> elements, std::span<const std::uint8_t> active,
                               const base::Host& host) {
  const std::size_t vertices = active.size();
  const auto for_pairs = [&](const Element& e, const auto& visit) {
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t l = 0; l < k; ++l) {
        const Index v = e.corner[k], w = e.corner[l];
        if (active[v] != 0 && active[w] != 0) visit(std::max(v, w), std::min(v, w), pair[k][l]);
      }
    }
  };
  // Lower neighbors of each vertex with repetitions, then without.
  const auto for_each_pair = [&](const auto& visit) {
    host.report("matrix", 0, vertices);
    for (const Element& e : elements)
      for_pairs(e, [&](Index row, Index column, std::size_t) { visit(row, column); });
  };
  base::Groups<Index> lower(vertices, for_each_pair, host.memory);
  matrix_.row_begin.assign(vertices + 1, 0);
  for (std::size_t v = 0; v < vertices; ++v) {
    if (v % 4096 == 0) host.report("matrix", v, vertices);
    const std::span<Index> columns = lower[v];
    std::sort(columns.begin(), columns.end());
    const auto last = std::unique(columns.begin(), columns.end());
    matrix_.column.insert(matrix_.column.end(), columns.begin(), last);
    matrix_.row_begin[v + 1] = static_cast<Index>(matrix_.column.size());
  }
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (i % rows_at_once == 0) host.report("matrix", 0, 0);
    for_pairs(elements[i], [&](Index row, Index column, std::size_t which) {
      const auto first = matrix_.column.begin() + static_cast<std::ptrdiff_t>(matrix_.row_begin[row]);
      const auto last = matrix_.column.begin() + static_cast<std::ptrdiff_t>(matrix_.row_begin[row + 1]);
      place_[6 * i + which] = static_cast<Index>(std::lower_bound(first, last, column) - matrix_.column.begin());
    });
  }
}

void BlockAssembly::add_shares(const base::Host& host) {
  const std::size_t rows = matrix_.rows(), own = variables_.own(), shared = variables_.free() - own;
  const auto group = [&](std::size_t v, std::size_t a) {
    return variables_.is_free(v, a) && !variables_.is_own(v, a) ? variables_.of(v, a) - static_cast<Index>(own)
                                                                : no_index;
  };
  // Places by row and column of the border and of the corner; `place` of a share is its column until all are known.
  Array<std::pair<Index, Index>> border(host.memory), corner(host.memory);
  Array<Index> share_row(host.memory);  // the shared unknown of each share
  const auto add = [&](Kind kind, std::size_t block, std::size_t a, std::size_t b, Index row, Index column) {
    shares_.push_back(
        {static_cast<Index>(block), column, kind, static_cast<std::uint8_t>(a), static_cast<std::uint8_t>(b)});
    share_row.push_back(row);
    if (kind == Kind::row || kind == Kind::column) border.push_back({row, column});
    if (kind == Kind::corner) corner.push_back({row, column});
  };
  const auto add_block = [&](std::size_t block, Index v, Index w) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (group(v, a) != no_index && matrix_.own[w] != 0) add(Kind::row, block, a, 0, group(v, a), w);
      if (v != w && group(w, a) != no_index && matrix_.own[v] != 0) add(Kind::column, block, 0, a, group(w, a), v);
      for (std::size_t b = 0; b < (v == w ? a + 1 : 3); ++b) {
        const Index g = group(v, a), h = group(w, b);
        if (g == no_index || h == no_index) continue;
        if (g == h)
          add(v == w && a == b ? Kind::diagonal : Kind::twice, block, a, b, g, g);
        else
          add(Kind::corner, block, a, b, std::max(g, h), std::min(g, h));
      }
    }
  };
  for (Index v = 0; v < rows; ++v) {
    if (v % 4096 == 0) host.report("matrix", v, rows);
    for (Index i = matrix_.row_begin[v]; i < matrix_.row_begin[v + 1]; ++i)
      add_block(i, v, matrix_.column[i]);
    add_block(matrix_.lower.size() + v, v, v);
  }
  host.report("matrix", 0, 0);
  linear::make_rows(border, shared, matrix_.border_begin, matrix_.border_column);
  linear::make_rows(corner, shared, matrix_.corner_begin, matrix_.corner_column);
  matrix_.border.assign(border.size(), Vector3::Zero());
  matrix_.corner.assign(corner.size(), 0.0);
  matrix_.corner_diagonal.assign(shared, 0.0);
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    Share& share = shares_[i];
    if (share.kind == Kind::diagonal || share.kind == Kind::twice) continue;
    const auto& places = share.kind == Kind::corner ? corner : border;
    const std::pair<Index, Index> key{share_row[i], share.place};
    share.place = static_cast<Index>(std::lower_bound(places.begin(), places.end(), key) - places.begin());
  }
}

void BlockAssembly::finish(const base::ThreadPool& pool) {
  BlockMatrix& m = matrix_;
  std::fill(m.border.begin(), m.border.end(), Vector3::Zero());
  std::fill(m.corner.begin(), m.corner.end(), 0.0);
  std::fill(m.corner_diagonal.begin(), m.corner_diagonal.end(), 0.0);
  for (const Share& share : shares_) {
    const Eigen::Matrix3d& block =
        share.block < m.lower.size() ? m.lower[share.block] : m.diagonal[share.block - m.lower.size()];
    switch (share.kind) {
      case Kind::row:
        m.border[share.place] += block.row(share.row).transpose();
        break;
      case Kind::column:
        m.border[share.place] += block.col(share.column);
        break;
      case Kind::corner:
        m.corner[share.place] += block(share.row, share.column);
        break;
      case Kind::diagonal:
        m.corner_diagonal[share.place] += block(share.row, share.column);
        break;
      case Kind::twice:
        m.corner_diagonal[share.place] += 2 * block(share.row, share.column);
        break;
    }
  }
  for (std::size_t i = 0; i < m.border.size(); ++i) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (!m.is_own(m.border_column[i], a)) m.border[i][static_cast<Eigen::Index>(a)] = 0;
    }
  }
  pool.run_pieces(m.rows(), rows_a_piece, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      // What is no unknown has the size of the rest, or 1.
      Eigen::Matrix3d& diagonal = m.diagonal[v];
      const double trace = diagonal.trace();
      for (std::size_t a = 0; a < 3; ++a) {
        if (m.is_own(v, a)) continue;
        const auto at = static_cast<Eigen::Index>(a);
        diagonal.row(at).setZero();
        diagonal.col(at).setZero();
        diagonal(at, at) = trace > 0 ? trace : 1;
      }
      for (Index i = m.row_begin[v]; i < m.row_begin[v + 1]; ++i) {
        for (std::size_t a = 0; a < 3; ++a) {
          const auto at = static_cast<Eigen::Index>(a);
          if (!m.is_own(v, a)) m.lower[i].row(at).setZero();
          if (!m.is_own(m.column[i], a)) m.lower[i].col(at).setZero();
        }
      }
    }
  });
}

void BlockAssembly::scatter(std::span<const double> free, std::span<double> entries) const {
  for (std::size_t v = 0; v < matrix_.rows(); ++v) {
    for (std::size_t a = 0; a < 3; ++a)
      entries[3 * v + a] = variables_.is_own(v, a) ? free[variables_.of(v, a)] : 0;
  }
  std::copy(free.begin() + static_cast<std::ptrdiff_t>(variables_.own()), free.end(),
            entries.begin() + static_cast<std::ptrdiff_t>(3 * matrix_.rows()));
}

void BlockAssembly::gather(std::span<const double> entries, std::span<double> free) const {
  for (std::size_t v = 0; v < matrix_.rows(); ++v) {
    for (std::size_t a = 0; a < 3; ++a) {
      if (variables_.is_own(v, a)) free[variables_.of(v, a)] = entries[3 * v + a];
    }
  }
  std::copy(entries.begin() + static_cast<std::ptrdiff_t>(3 * matrix_.rows()), entries.end(),
            free.begin() + static_cast<std::ptrdiff_t>(variables_.own()));
}

}  // namespace orbicube::untangle
