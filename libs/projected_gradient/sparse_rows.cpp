#include "projected_gradient/sparse_rows.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

#include "base/error.h"
#include "base/grouping.h"
#include "projected_gradient/vector_math.h"

namespace orbicube::projected_gradient {
namespace {

// The same bits with every C library, as those of std::hypot are not. No square is out of range.
double length_of(std::span<const double> row) {
  double largest = 0;
  for (const double x : row)
    largest = std::max(largest, std::abs(x));
  if (largest == 0 || !std::isfinite(largest)) return largest;
  const int exponent = std::ilogb(largest);
  double sum = 0;
  for (const double x : row) {
    const double scaled = std::scalbn(x, -exponent);
    sum += scaled * scaled;
  }
  return std::scalbn(std::sqrt(sum), exponent);
}

}  // namespace

SparseRows::SparseRows(const Problem& problem, std::pmr::memory_resource* memory)
    : row_start_(memory),
      column_start_(memory),
      column_(memory),
      column_row_(memory),
      value_(memory),
      column_value_(memory),
      rhs_(memory),
      scale_(memory) {
  const std::size_t m = problem.rows(), n = problem.n;
  column_start_.assign(n + 1, 0);
  row_start_.assign(m + 1, 0);
  if (m == 0) return;
  if (problem.row_start.size() != m + 1 || problem.row_start[0] != 0 || problem.row_start[m] != problem.column.size() ||
      problem.column.size() != problem.value.size()) {
    throw base::Error("invalid-argument", "row_start does not span the entries of A");
  }
  column_.reserve(problem.column.size());
  value_.reserve(problem.column.size());
  rhs_.resize(m);
  scale_.resize(m);
  base::Array<std::size_t> place(n, std::size_t(-1), memory);
  for (std::size_t i = 0; i < m; ++i) {
    add_entries(problem, i, place);
    scale_row(problem.rhs[i], i);
  }
  list_columns();
}

// `place`: of each column, where this row already holds it.
void SparseRows::add_entries(const Problem& problem, std::size_t i, std::span<std::size_t> place) {
  // Beyond the entries is backwards, too: a later row must come back to where the entries end.
  if (problem.row_start[i] > problem.row_start[i + 1] || problem.row_start[i + 1] > problem.column.size()) {
    throw base::Error("invalid-argument", "row_start decreases at row " + std::to_string(i));
  }
  for (std::size_t k = problem.row_start[i]; k < problem.row_start[i + 1]; ++k) {
    const std::uint32_t j = problem.column[k];
    if (j >= problem.n || !std::isfinite(problem.value[k])) {
      throw base::Error("invalid-argument", "row " + std::to_string(i) + " of A has a column out of range or a value " +
                                                "that is not finite");
    }
    if (place[j] != std::size_t(-1) && place[j] >= row_start_[i]) {
      value_[place[j]] += problem.value[k];
    } else {
      place[j] = column_.size();
      column_.push_back(j);
      value_.push_back(problem.value[k]);
    }
  }
  row_start_[i + 1] = column_.size();
}

void SparseRows::scale_row(double rhs, std::size_t i) {
  if (!std::isfinite(rhs)) throw base::Error("invalid-argument", "b[" + std::to_string(i) + "] is not finite");
  const double length = length_of({value_.data() + row_start_[i], row_start_[i + 1] - row_start_[i]});
  // So that neither the row over its length nor squares of what belongs to it leave the range of double.
  if (length > 0 && !(length >= 1e-150 && length <= 1e150))
    throw base::Error("invalid-argument",
                      "row " + std::to_string(i) + " of A is shorter than 1e-150 or longer than 1e150");
  scale_[i] = length > 0 ? 1 / length : 1;
  for (std::size_t k = row_start_[i]; k < row_start_[i + 1]; ++k)
    value_[k] *= scale_[i];
  rhs_[i] = rhs * scale_[i];
  if (!(std::abs(rhs_[i]) <= max_coordinate))
    throw base::Error("invalid-argument", "b[" + std::to_string(i) + "] over its row is beyond 1e150");
}

void SparseRows::list_columns() {
  column_row_.resize(column_.size());
  column_value_.resize(column_.size());
  base::group_by_key(
      std::span(column_start_),
      [&](const auto& visit) {
        for (std::size_t i = 0; i < rows(); ++i) {
          for (std::size_t k = row_start_[i]; k < row_start_[i + 1]; ++k)
            visit(column_[k], static_cast<std::uint32_t>(i), value_[k]);
        }
      },
      [](std::size_t) {},
      [&](std::size_t at, std::uint32_t row, double value) {
        column_row_[at] = row;
        column_value_[at] = value;
      });
}

double SparseRows::residual(std::span<const double> x, std::span<double> out) const {
  double worst = 0;
  for (std::size_t i = 0; i < rows(); ++i) {
    const double* value = value_.data() + row_start_[i];
    const std::uint32_t* column = column_.data() + row_start_[i];
    const std::size_t count = row_start_[i + 1] - row_start_[i];
    const double sum = blocked_sum(count, [&](std::size_t k) { return value[k] * x[column[k]]; });
    const double scale = blocked_sum(count, [&](std::size_t k) { return std::abs(value[k] * x[column[k]]); });
    out[i] = rhs_[i] - sum;
    if (out[i] != 0) worst = std::max(worst, std::abs(out[i]) / (scale + std::abs(rhs_[i])));
  }
  return worst;
}

void SparseRows::multiply_free(std::span<const double> x, std::span<const std::uint8_t> free,
                               std::span<double> out) const {
  for (std::size_t i = 0; i < rows(); ++i) {
    const double* value = value_.data() + row_start_[i];
    const std::uint32_t* column = column_.data() + row_start_[i];
    out[i] = blocked_sum(row_start_[i + 1] - row_start_[i],
                         [&](std::size_t k) { return free[column[k]] ? value[k] * x[column[k]] : 0.0; });
  }
}

}  // namespace orbicube::projected_gradient
