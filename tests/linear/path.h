// A sparse matrix for the tests of the interfaces of linear.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "orbicube/linear.h"

namespace orbicube::test {

// The lower triangle of the Laplacian of a path of n vertices plus 1/10.
struct Path {
  std::vector<std::size_t> row_begin{0};
  std::vector<std::uint32_t> columns;
  std::vector<double> values;

  explicit Path(std::uint32_t n) {
    for (std::uint32_t i = 0; i < n; ++i) {
      if (i > 0) {
        columns.push_back(i - 1);
        values.push_back(-1);
      }
      columns.push_back(i);
      values.push_back(2.1);
      row_begin.push_back(columns.size());
    }
  }
  obc_linear_matrix view() const { return {row_begin.size() - 1, row_begin.data(), columns.data(), values.data()}; }
  // The largest entry of b - A x.
  double residual(const std::vector<double>& b, const std::vector<double>& x) const {
    std::vector<double> rest = b;
    for (std::size_t row = 0; row < b.size(); ++row) {
      for (std::size_t i = row_begin[row]; i < row_begin[row + 1]; ++i) {
        rest[row] -= values[i] * x[columns[i]];
        if (columns[i] != row) rest[columns[i]] -= values[i] * x[row];
      }
    }
    double largest = 0;
    for (const double entry : rest)
      largest = std::max(largest, std::abs(entry));
    return largest;
  }
};

}  // namespace orbicube::test
