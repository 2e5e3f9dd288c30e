// Systems to try the solvers with.
#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "linear/symmetric_matrix.h"

namespace orbicube::linear::test {

// A symmetric matrix that owns its arrays.
struct Matrix {
  std::vector<std::size_t> row_begin{0};
  std::vector<Index> columns;
  std::vector<double> values;

  SymmetricMatrix view() const { return {row_begin, columns, values}; }
  std::size_t size() const { return row_begin.size() - 1; }
  void add(Index column, double value) {
    columns.push_back(column);
    values.push_back(value);
  }
  void end_row() { row_begin.push_back(columns.size()); }
  Eigen::MatrixXd dense() const {
    Eigen::MatrixXd result =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(size()), static_cast<Eigen::Index>(size()));
    for (Eigen::Index row = 0; row < result.rows(); ++row) {
      for (std::size_t i = row_begin[static_cast<std::size_t>(row)]; i < row_begin[static_cast<std::size_t>(row) + 1];
           ++i)
        result(row, columns[i]) = result(columns[i], row) = values[i];
    }
    return result;
  }
};

// The Laplacian of a grid of n x n x n points, `unknowns` for each that are coupled at their point, plus `shift` on the
// diagonal. Coefficients vary at random by the factor `contrast`.
inline Matrix laplacian(int n, int unknowns, double shift, double contrast = 1) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto at = [&](int i, int j, int k) { return static_cast<std::size_t>((i * n + j) * n + k); };
  const std::size_t points = at(n - 1, n - 1, n - 1) + 1;
  std::vector<double> sum(points, shift);
  std::vector<std::vector<std::pair<std::size_t, double>>> lower(points);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      for (int k = 0; k < n; ++k) {
        const auto join = [&](bool inside, std::size_t other) {
          if (!inside) return;
          const double c = std::pow(contrast, uniform(random));
          lower[at(i, j, k)].push_back({other, c});
          sum[at(i, j, k)] += c;
          sum[other] += c;
        };
        join(i > 0, i > 0 ? at(i - 1, j, k) : 0);
        join(j > 0, j > 0 ? at(i, j - 1, k) : 0);
        join(k > 0, k > 0 ? at(i, j, k - 1) : 0);
      }
    }
  }
  Matrix result;
  for (std::size_t p = 0; p < points; ++p) {
    for (int u = 0; u < unknowns; ++u) {
      for (const auto& [other, c] : lower[p])
        result.add(static_cast<Index>(other * static_cast<std::size_t>(unknowns)) + static_cast<Index>(u), -c);
      for (int w = 0; w < u; ++w)
        result.add(static_cast<Index>(p * static_cast<std::size_t>(unknowns)) + static_cast<Index>(w), 0.2 * shift);
      result.add(static_cast<Index>(p * static_cast<std::size_t>(unknowns)) + static_cast<Index>(u), sum[p]);
      result.end_row();
    }
  }
  return result;
}

inline std::vector<double> random_vector(std::size_t size, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<double> result(size);
  for (double& entry : result)
    entry = uniform(random);
  return result;
}

// |b - A x| / |b|, by the matrix itself.
inline double residual(const Matrix& matrix, std::span<const double> right, std::span<const double> solution) {
  std::vector<double> image(right.size());
  matrix.view().multiply(solution, image);
  double above = 0, below = 0;
  for (std::size_t i = 0; i < right.size(); ++i) {
    above += (right[i] - image[i]) * (right[i] - image[i]);
    below += right[i] * right[i];
  }
  return std::sqrt(above / below);
}

}  // namespace orbicube::linear::test
