#include "suite.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace orbicube::bench {

const std::vector<SuiteRow>& suite_rows() {
  static const std::vector<SuiteRow> rows = [] {
    std::vector<SuiteRow> all = suite_squares();
    for (const auto& more : {suite_values(), suite_bounded()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return rows;
}

void suite_residuals(std::size_t index, std::size_t n, const double* x, double* r) {
  suite_rows()[index].evaluate(n, x, r);
}

namespace {

double entry(const std::vector<double>& pattern, std::size_t i) {
  return pattern[i % pattern.size()];
}

// An orthogonal matrix by Gram and Schmidt.
std::vector<double> orthogonal(std::size_t n, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> q(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    double* row = q.data() + i * n;
    for (std::size_t j = 0; j < n; ++j)
      row[j] = normal(random);
    for (std::size_t k = 0; k < 2 * i; ++k) {
      const double* other = q.data() + (k % i) * n;
      double along = 0;
      for (std::size_t j = 0; j < n; ++j)
        along += row[j] * other[j];
      for (std::size_t j = 0; j < n; ++j)
        row[j] -= along * other[j];
    }
    double square = 0;
    for (std::size_t j = 0; j < n; ++j)
      square += row[j] * row[j];
    for (std::size_t j = 0; j < n; ++j)
      row[j] /= std::sqrt(square);
  }
  return q;
}

}  // namespace

Problem make_suite_case(std::size_t index) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const SuiteRow& row = suite_rows()[index];
  Problem p;
  p.name = row.name;
  p.family = Problem::suite + static_cast<int>(index);
  p.n = row.n;
  p.m = row.m == 0 ? 1 : row.m;
  p.squares = row.m > 0;
  std::mt19937_64 random(77 + index);
  const bool boxed = !row.lower.empty();
  std::vector<double> turn(p.n * p.n);
  for (std::size_t i = 0; i < p.n; ++i)
    turn[i * p.n + i] = 1;
  if (!boxed) turn = orthogonal(p.n, random);
  // x = turn' diag(scale) u, scales from 1/2 to 2.
  p.start.assign(p.n, 0.0);
  p.lower.assign(p.n, -infinity);
  p.upper.assign(p.n, infinity);
  p.rotation = turn;
  for (std::size_t i = 0; i < p.n; ++i) {
    const double scale = std::exp2(static_cast<double>(random() >> 11) * 0x1p-52 - 1);
    for (std::size_t j = 0; j < p.n; ++j) {
      p.start[i] += turn[i * p.n + j] * (entry(row.start, j) + row.slope * static_cast<double>(j)) / scale;
      p.rotation[i * p.n + j] *= scale;
    }
    if (!boxed) continue;
    // Beyond 1e19 there is no bound.
    if (const double bound = entry(row.lower, i); bound > -1e19) p.lower[i] = bound / scale;
    if (const double bound = entry(row.upper, i); bound < 1e19) p.upper[i] = bound / scale;
  }
  for (std::size_t i = 0; i < p.n; ++i)
    p.start[i] = std::clamp(p.start[i], p.lower[i], p.upper[i]);
  return p;
}

}  // namespace orbicube::bench
