#include "linear/symmetric_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.h"
#include "base/grouping.h"

namespace orbicube::linear {

void SymmetricMatrix::multiply(std::span<const double> x, std::span<double> y) const {
  std::fill(y.begin(), y.end(), 0.0);
  for (std::size_t row = 0; row < size(); ++row) {
    double sum = 0;
    std::size_t i = row_begin[row];
    for (; i + 1 < row_begin[row + 1]; ++i) {
      sum += values[i] * x[columns[i]];
      y[columns[i]] += values[i] * x[row];
    }
    y[row] += sum + values[i] * x[row];
  }
}

void require_valid(const SymmetricMatrix& matrix) {
  const auto fail = [](std::size_t row, const char* what) {
    throw base::Error("invalid-argument", "row " + std::to_string(row) + " of the matrix: " + what);
  };
  base::require(matrix.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max()) &&
                    matrix.values.size() <= static_cast<std::size_t>(std::numeric_limits<int>::max()),
                "the matrix has more than 2^31 - 1 rows or entries");
  base::require(matrix.row_begin.front() == 0, "row_begin[0] is not 0");
  for (std::size_t row = 0; row < matrix.size(); ++row) {
    const std::size_t begin = matrix.row_begin[row], end = matrix.row_begin[row + 1];
    if (end < begin || end > matrix.columns.size()) fail(row, "row_begin descends or exceeds the number of entries");
    if (end == begin || matrix.columns[end - 1] != row) fail(row, "its last entry is not the diagonal");
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin && matrix.columns[i] <= matrix.columns[i - 1]) fail(row, "its columns do not ascend");
      if (!std::isfinite(matrix.values[i])) fail(row, "a value is not finite");
    }
  }
}

SparseMatrix by_columns(const SymmetricMatrix& matrix, Array<int>& place) {
  const std::size_t size = matrix.size(), count = matrix.row_begin.back();
  SparseMatrix result(static_cast<int>(size), static_cast<int>(size));
  result.resizeNonZeros(static_cast<Eigen::Index>(count));
  int* const begin = result.outerIndexPtr();
  place.resize(count);
  base::group_by_key(
      std::span(begin, size + 1),
      [&](const auto& visit) {
        for (std::size_t row = 0; row < size; ++row) {
          for (std::size_t i = matrix.row_begin[row]; i < matrix.row_begin[row + 1]; ++i)
            visit(matrix.columns[i], row, i);
        }
      },
      [](int) {},
      [&](int at, std::size_t row, std::size_t i) {
        place[i] = at;
        result.innerIndexPtr()[at] = static_cast<int>(row);
        result.valuePtr()[at] = matrix.values[i];
      });
  return result;
}

template <int block>
BlockMatrix<block> in_blocks(const SymmetricMatrix& matrix, const base::Host& host) {
  using Matrix = BlockMatrix<block>;
  const std::size_t rows = matrix.size() / Matrix::unknowns;
  Matrix result(host.memory);
  Array<std::pair<Index, Index>> places(host.memory);
  const auto for_each_entry = [&](const auto& visit) {
    for (std::size_t row = 0; row < matrix.size(); ++row) {
      if (row % 16384 == 0) host.report("matrix", row, matrix.size());
      for (std::size_t i = matrix.row_begin[row]; i < matrix.row_begin[row + 1]; ++i) {
        const std::size_t column = matrix.columns[i];
        visit(static_cast<Index>(row / Matrix::unknowns), static_cast<Index>(column / Matrix::unknowns),
              static_cast<Eigen::Index>(row % Matrix::unknowns), static_cast<Eigen::Index>(column % Matrix::unknowns),
              matrix.values[i]);
      }
    }
  };
  for_each_entry([&](Index row, Index column, Eigen::Index, Eigen::Index, double) {
    if (column < row && (places.empty() || places.back() != std::pair(row, column))) places.push_back({row, column});
  });
  make_rows(places, rows, result.row_begin, result.column);
  result.lower.assign(result.column.size(), Matrix::Block::Zero());
  result.diagonal.assign(rows, Matrix::Block::Zero());
  result.own.assign(rows, static_cast<std::uint8_t>((1U << block) - 1));
  result.border_begin.assign(1, 0);
  result.corner_begin.assign(1, 0);
  for_each_entry([&](Index row, Index column, Eigen::Index r, Eigen::Index c, double value) {
    if (row == column) {
      result.diagonal[row](r, c) = result.diagonal[row](c, r) = value;
      return;
    }
    const auto first = result.column.begin() + static_cast<std::ptrdiff_t>(result.row_begin[row]);
    const auto last = result.column.begin() + static_cast<std::ptrdiff_t>(result.row_begin[row + 1]);
    result.lower[static_cast<std::size_t>(std::lower_bound(first, last, column) - result.column.begin())](r, c) = value;
  });
  return result;
}

template BlockMatrix<1> in_blocks<1>(const SymmetricMatrix& matrix, const base::Host& host);
template BlockMatrix<2> in_blocks<2>(const SymmetricMatrix& matrix, const base::Host& host);
template BlockMatrix<3> in_blocks<3>(const SymmetricMatrix& matrix, const base::Host& host);

}  // namespace orbicube::linear
