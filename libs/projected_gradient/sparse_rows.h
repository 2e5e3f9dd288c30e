// The rows of A x = b, kept by rows and by columns, each row scaled to length 1 (with its b), equal columns merged.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

#include "base/array.h"
#include "projected_gradient/problem.h"

namespace orbicube::projected_gradient {

class SparseRows {
 public:
  // Throws invalid-argument when an index is out of range, the offsets decrease or a number is not finite.
  SparseRows(const Problem& problem, std::pmr::memory_resource* memory);

  std::size_t rows() const { return rhs_.size(); }
  std::span<const double> rhs() const { return rhs_; }

  // out = b - A x; returns the largest |a'x - b| / (|b| + sum |a_j x_j|) of a row.
  double residual(std::span<const double> x, std::span<double> out) const;
  // out = A x over the unknowns whose `free` is not 0.
  void multiply_free(std::span<const double> x, std::span<const std::uint8_t> free, std::span<double> out) const;
  // (A' t)_j
  double column_times(std::size_t j, std::span<const double> t) const {
    double sum = 0;
    for (std::size_t k = column_start_[j]; k < column_start_[j + 1]; ++k)
      sum += column_value_[k] * t[column_row_[k]];
    return sum;
  }
  // Multipliers of the scaled rows to those of the rows as given.
  double scale(std::size_t row) const { return scale_[row]; }

  std::span<const std::uint32_t> row_columns(std::size_t i) const {
    return {column_.data() + row_start_[i], row_start_[i + 1] - row_start_[i]};
  }
  std::span<const double> row_values(std::size_t i) const {
    return {value_.data() + row_start_[i], row_start_[i + 1] - row_start_[i]};
  }
  std::span<const std::uint32_t> column_rows(std::size_t j) const {
    return {column_row_.data() + column_start_[j], column_start_[j + 1] - column_start_[j]};
  }
  std::span<const double> column_values(std::size_t j) const {
    return {column_value_.data() + column_start_[j], column_start_[j + 1] - column_start_[j]};
  }

 private:
  void add_entries(const Problem& problem, std::size_t row, std::span<std::size_t> place);
  void scale_row(double rhs, std::size_t row);
  void list_columns();

  base::Array<std::size_t> row_start_, column_start_;
  base::Array<std::uint32_t> column_, column_row_;
  base::Array<double> value_, column_value_, rhs_, scale_;
};

}  // namespace orbicube::projected_gradient
