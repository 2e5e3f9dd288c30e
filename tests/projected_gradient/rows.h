// Problems written as lists, for the tests: owns what projected_gradient::Problem only views.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "base/host.h"
#include "projected_gradient/feasible_set.h"
#include "projected_gradient/problem.h"

namespace orbicube::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

struct Constraints {
  std::vector<double> lower, upper;
  std::vector<std::size_t> row_start{0};
  std::vector<std::uint32_t> column;
  std::vector<double> value, rhs;

  explicit Constraints(std::size_t n, double low = -infinity, double high = infinity) : lower(n, low), upper(n, high) {}

  void add_row(const std::vector<std::pair<std::uint32_t, double>>& entries, double b) {
    for (const auto& [j, a] : entries) {
      column.push_back(j);
      value.push_back(a);
    }
    row_start.push_back(column.size());
    rhs.push_back(b);
  }
  std::size_t size() const { return lower.size(); }
  std::size_t rows() const { return rhs.size(); }

  projected_gradient::Problem problem() const {
    projected_gradient::Problem p;
    p.n = size();
    p.lower = lower;
    p.upper = upper;
    if (!rhs.empty()) {
      p.row_start = row_start;
      p.column = column;
      p.value = value;
      p.rhs = rhs;
    }
    return p;
  }

  // A'c, with the rows as given.
  std::vector<double> transposed_times(const std::vector<double>& c) const {
    std::vector<double> out(size());
    for (std::size_t i = 0; i < rows(); ++i) {
      for (std::size_t k = row_start[i]; k < row_start[i + 1]; ++k)
        out[column[k]] += value[k] * c[i];
    }
    return out;
  }

  // Largest |a'x - b| / (|b| + sum |a_j x_j|) of a row, in extended precision.
  double residual(const std::vector<double>& x) const {
    double worst = 0;
    for (std::size_t i = 0; i < rows(); ++i) {
      long double sum = -rhs[i], scale = std::abs(rhs[i]);
      for (std::size_t k = row_start[i]; k < row_start[i + 1]; ++k) {
        const long double term = static_cast<long double>(value[k]) * x[column[k]];
        sum += term;
        scale += std::abs(term);
      }
      if (sum != 0) worst = std::max(worst, static_cast<double>(std::abs(sum) / scale));
    }
    return worst;
  }

  bool within_bounds(const std::vector<double>& x) const {
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (!(x[j] >= lower[j] && x[j] <= upper[j])) return false;
    }
    return true;
  }
};

// What a projection gives, with multipliers of the rows as given.
struct Projection {
  projected_gradient::Projected outcome;
  std::vector<double> x, multipliers;
  std::uint64_t passes;
};

inline Projection project(const Constraints& constraints, const std::vector<double>& y) {
  const base::Host host;
  projected_gradient::FeasibleSet set(constraints.problem(), host.memory);
  Projection result;
  result.x.resize(constraints.size());
  result.outcome = set.project(y, result.x, 1, host);
  result.passes = set.passes();
  for (std::size_t i = 0; i < constraints.rows(); ++i) {
    result.multipliers.push_back(set.guess()[i] * set.linear_rows().scale(i));
  }
  return result;
}

}  // namespace orbicube::test
