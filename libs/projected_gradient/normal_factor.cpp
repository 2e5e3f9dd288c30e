#include "projected_gradient/normal_factor.h"

#include <algorithm>

#include "base/grouping.h"

namespace orbicube::projected_gradient {
namespace {

using Lists = base::Array<base::Array<std::uint32_t>>;

// The rows that share an unknown with each row.
Lists neighbors_of(const SparseRows& rows, std::pmr::memory_resource* memory) {
  Lists neighbors(rows.rows(), memory);
  base::Array<std::uint32_t> seen(rows.rows(), 0, memory);
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    seen[i] = static_cast<std::uint32_t>(i + 1);
    for (const std::uint32_t j : rows.row_columns(i)) {
      for (const std::uint32_t other : rows.column_rows(j)) {
        if (seen[other] == i + 1) continue;
        seen[other] = static_cast<std::uint32_t>(i + 1);
        neighbors[i].push_back(other);
      }
    }
  }
  return neighbors;
}

}  // namespace

NormalFactor::NormalFactor(const SparseRows& rows, std::pmr::memory_resource* memory)
    : order_(memory),
      position_(rows.rows(), 0, memory),
      start_(memory),
      column_(memory),
      value_(memory),
      inverse_pivot_(rows.rows(), 0.0, memory),
      work_(rows.rows(), 0.0, memory),
      permuted_(rows.rows(), 0.0, memory) {
  const std::size_t m = rows.rows();
  order_.reserve(m);
  // Minimum degree on the explicit graph: the neighbors of the row taken out become a clique. The lists left at each
  // row's elimination are the pattern of its column of L.
  Lists later = neighbors_of(rows, memory);
  base::Array<std::uint8_t> done(m, 0, memory);
  base::Array<std::uint32_t> seen(m, 0, memory);
  std::uint32_t stamp = 0;
  for (std::size_t k = 0; k < m; ++k) {
    std::size_t best = m;
    for (std::size_t i = 0; i < m; ++i) {
      if (!done[i] && (best == m || later[i].size() < later[best].size())) best = i;
    }
    done[best] = 1;
    position_[best] = static_cast<std::uint32_t>(k);
    order_.push_back(static_cast<std::uint32_t>(best));
    for (const std::uint32_t i : later[best]) {
      ++stamp;
      std::erase(later[i], static_cast<std::uint32_t>(best));
      for (const std::uint32_t known : later[i])
        seen[known] = stamp;
      seen[i] = stamp;
      for (const std::uint32_t other : later[best]) {
        if (seen[other] != stamp) later[i].push_back(other);
      }
    }
  }
  start_.resize(m + 1);
  base::group_by_key(
      std::span(start_),
      [&](const auto& visit) {
        for (std::size_t k = 0; k < m; ++k) {  // by ascending column, so that each row of L is sorted
          for (const std::uint32_t below : later[order_[k]])
            visit(position_[below], static_cast<std::uint32_t>(k));
        }
      },
      [&](std::size_t count) {
        column_.resize(count);
        value_.resize(count);
      },
      [&](std::size_t at, std::uint32_t column) { column_[at] = column; });
}

void NormalFactor::factor(const SparseRows& rows, std::span<const std::uint8_t> free, double shift) {
  // A pivot below this part of its diagonal entry is what rounding leaves of zero.
  constexpr double dependent = 1e-12;
  const std::size_t m = order_.size();
  std::fill(work_.begin(), work_.end(), 0.0);
  for (std::size_t k = 0; k < m; ++k) {
    const std::uint32_t i = order_[k];
    double diagonal = shift;
    const auto columns = rows.row_columns(i);
    const auto values = rows.row_values(i);
    for (std::size_t p = 0; p < columns.size(); ++p) {
      if (!free[columns[p]]) continue;
      const auto others = rows.column_rows(columns[p]);
      const auto other_values = rows.column_values(columns[p]);
      for (std::size_t q = 0; q < others.size(); ++q) {
        if (position_[others[q]] < k) work_[position_[others[q]]] += values[p] * other_values[q];
      }
      diagonal += values[p] * values[p];
    }
    // Row k of L D solves the triangular system of the rows before it.
    double pivot = diagonal;
    for (std::size_t p = start_[k]; p < start_[k + 1]; ++p) {
      const std::uint32_t c = column_[p];
      double entry = work_[c];
      for (std::size_t q = start_[c]; q < start_[c + 1]; ++q)
        entry -= value_[q] * work_[column_[q]];
      work_[c] = entry;
    }
    for (std::size_t p = start_[k]; p < start_[k + 1]; ++p) {
      const std::uint32_t c = column_[p];
      value_[p] = work_[c] * inverse_pivot_[c];
      pivot -= value_[p] * work_[c];
      work_[c] = 0;
    }
    inverse_pivot_[k] = pivot > dependent * diagonal && pivot > 0 ? 1 / pivot : 0;
  }
}

void NormalFactor::solve(std::span<double> x) const {
  const std::size_t m = order_.size();
  for (std::size_t k = 0; k < m; ++k) {
    double entry = x[order_[k]];
    for (std::size_t p = start_[k]; p < start_[k + 1]; ++p)
      entry -= value_[p] * permuted_[column_[p]];
    permuted_[k] = entry;
  }
  for (std::size_t k = 0; k < m; ++k)
    permuted_[k] *= inverse_pivot_[k];
  for (std::size_t k = m; k-- > 0;) {
    for (std::size_t p = start_[k]; p < start_[k + 1]; ++p)
      permuted_[column_[p]] -= value_[p] * permuted_[k];
  }
  for (std::size_t k = 0; k < m; ++k)
    x[order_[k]] = permuted_[k];
}

}  // namespace orbicube::projected_gradient
