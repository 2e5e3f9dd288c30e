#include "problems.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "families.h"
#include "suite.h"

namespace orbicube::bench {
namespace {

struct Row {
  int family;
  std::size_t n, m;
  int power;  // of ten, that the standard start is multiplied by
};

// The list of the paper's 53 cases.
constexpr std::array<Row, case_count> rows = {{
    {1, 9, 45, 0},   {1, 9, 45, 1},   {2, 7, 35, 0},   {2, 7, 35, 1},   {3, 7, 35, 0},   {3, 7, 35, 1},
    {4, 2, 2, 0},    {4, 2, 2, 1},    {5, 3, 3, 0},    {5, 3, 3, 1},    {6, 4, 4, 0},    {6, 4, 4, 1},
    {7, 2, 2, 0},    {7, 2, 2, 1},    {8, 3, 15, 0},   {8, 3, 15, 1},   {9, 4, 11, 0},   {10, 3, 16, 0},
    {11, 6, 31, 0},  {11, 6, 31, 1},  {11, 9, 31, 0},  {11, 9, 31, 1},  {11, 12, 31, 0}, {11, 12, 31, 1},
    {12, 3, 10, 0},  {13, 2, 10, 0},  {14, 4, 20, 0},  {14, 4, 20, 1},  {15, 6, 6, 0},   {15, 7, 7, 0},
    {15, 8, 8, 0},   {15, 9, 9, 0},   {15, 10, 10, 0}, {15, 11, 11, 0}, {16, 10, 10, 0}, {17, 5, 33, 0},
    {18, 11, 65, 0}, {18, 11, 65, 1}, {19, 8, 8, 0},   {19, 10, 12, 0}, {19, 11, 14, 0}, {19, 12, 16, 0},
    {20, 5, 5, 0},   {20, 6, 6, 0},   {20, 8, 8, 0},   {21, 5, 5, 0},   {21, 5, 5, 1},   {21, 8, 8, 0},
    {21, 10, 10, 0}, {21, 12, 12, 0}, {21, 12, 12, 1}, {22, 8, 8, 0},   {22, 8, 8, 1},
}};

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int rosenbrock_chain = 101, broyden_tridiagonal = 102, boundary_value = 103, variably_dimensioned = 104,
              signed_sum = 105;

// Uniform in [-1, 1], a fixed function of the point and the residual's number.
double noise_at(const double* x, std::size_t n, std::size_t i) {
  std::uint64_t state = 0x9e3779b97f4a7c15ULL * (i + 1);
  for (std::size_t j = 0; j < n; ++j) {
    std::uint64_t word;
    std::memcpy(&word, x + j, sizeof word);
    state = (state ^ word) * 0xbf58476d1ce4e5b9ULL;
    state ^= state >> 29;
  }
  state *= 0x94d049bb133111ebULL;
  state ^= state >> 31;
  return static_cast<double>(state >> 11) * 0x1p-52 - 1;
}

void large_residuals(int kind, std::size_t n, const double* x, double* r) {
  const auto at = [&](std::size_t i) { return i < n ? x[i] : 0.0; };
  const double h = 1 / static_cast<double>(n + 1);
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (kind == rosenbrock_chain && i + 1 < n) {
      r[2 * i] = 10 * (x[i + 1] - x[i] * x[i]);
      r[2 * i + 1] = 1 - x[i];
    } else if (kind == broyden_tridiagonal) {
      r[i] = (3 - 2 * x[i]) * x[i] - (i > 0 ? x[i - 1] : 0.0) - 2 * at(i + 1) + 1;
    } else if (kind == boundary_value) {
      const double t = static_cast<double>(i + 1) * h, cube = std::pow(x[i] + t + 1, 3);
      r[i] = (2 * x[i] - (i > 0 ? x[i - 1] : 0.0) - at(i + 1) + 0.5 * h * h * cube) / (h * h);
    } else if (kind == variably_dimensioned) {
      r[i] = x[i] - 1;
      sum += static_cast<double>(i + 1) * r[i];
    }
  }
  if (kind == variably_dimensioned) {
    r[n] = sum;
    r[n + 1] = sum * sum;
  }
}

// First n: weighted distances and products of neighbors. Then n with sign -1: smaller, of other sums.
void signed_residuals(std::size_t n, const double* x, double* r) {
  for (std::size_t i = 0; i < n; ++i) {
    const double next = x[(i + 1) % n], t = static_cast<double>(i + 1);
    r[i] = std::sqrt(t) * (x[i] - std::sin(t)) + 0.3 * x[i] * next;
    r[n + i] = 0.8 * std::cos(next + t) + 0.5 * x[i];
  }
}

}  // namespace

bool Problem::bounded() const {
  const auto finite = [](double value) { return std::isfinite(value); };
  return std::any_of(lower.begin(), lower.end(), finite) || std::any_of(upper.begin(), upper.end(), finite);
}

void Problem::residuals(const double* x, double* r) const {
  std::vector<double> turned;
  const double* at = x;
  if (!rotation.empty()) {
    turned.assign(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        turned[j] += rotation[i * n + j] * x[i];
    }
    at = turned.data();
  }
  if (family >= suite) {
    suite_residuals(static_cast<std::size_t>(family - suite), n, at, r);
  } else if (family == signed_sum) {
    signed_residuals(n, at, r);
  } else if (family > 100) {
    large_residuals(family, n, at, r);
  } else {
    family_residuals(family, n, m, at, r);
  }
  if (noise_relative > 0 || noise_absolute > 0) {
    for (std::size_t i = 0; i < m; ++i)
      r[i] = r[i] * (1 + noise_relative * noise_at(x, n, i)) + noise_absolute * noise_at(x, n, i + m);
  }
}

double Problem::objective(const std::vector<double>& r) const {
  if (!squares) return r[0];
  double sum = 0;
  for (std::size_t i = 0; norm != Norm::squares && i < m; ++i) {
    if (!(std::abs(r[i]) >= 0)) return r[i];
    sum = norm == Norm::magnitudes ? sum + std::abs(r[i]) : std::max(sum, std::abs(r[i]));
  }
  if (norm != Norm::squares) return sum;
  for (std::size_t i = 0; i < m; ++i)
    sum += (sign.empty() ? 1.0 : sign[i]) * r[i] * r[i];
  return sum;
}

double Problem::start_radius() const {
  double largest = 1;
  for (const double value : start)
    largest = std::max(largest, std::abs(value));
  return radius_part * largest;
}

Problem make_case(std::size_t index, int transform) {
  const Row& row = rows[index];
  Problem p;
  p.family = row.family;
  p.n = row.n;
  p.m = row.m;
  p.name = std::to_string(index + 1) + " (family " + std::to_string(row.family) + ", n " + std::to_string(row.n) + ")";
  const std::vector<double> standard = family_start(row.family, row.n);
  std::vector<double> start = standard;
  for (double& value : start)
    value *= std::pow(10.0, row.power);
  p.lower.assign(p.n, -infinity);
  p.upper.assign(p.n, infinity);
  if (transform > 0) {
    std::mt19937_64 random(1000 * static_cast<std::uint64_t>(transform) + index);
    const std::size_t n = p.n;
    p.rotation.assign(n * n, 0.0);
    if (transform > 6) {
      std::vector<std::size_t> order(n);
      for (std::size_t i = 0; i < n; ++i)
        order[i] = i;
      for (std::size_t i = n; i > 1; --i)
        std::swap(order[i - 1], order[random() % i]);
      for (std::size_t i = 0; i < n; ++i)
        p.rotation[i * n + order[i]] = 1;
    } else {
      // Gram and Schmidt of normal vectors.
      std::normal_distribution<double> normal;
      for (std::size_t i = 0; i < n; ++i) {
        double* row_i = p.rotation.data() + i * n;
        for (std::size_t j = 0; j < n; ++j)
          row_i[j] = normal(random);
        for (int twice = 0; twice < 2; ++twice) {
          for (std::size_t k = 0; k < i; ++k) {
            double along = 0;
            for (std::size_t j = 0; j < n; ++j)
              along += row_i[j] * p.rotation[k * n + j];
            for (std::size_t j = 0; j < n; ++j)
              row_i[j] -= along * p.rotation[k * n + j];
          }
        }
        double square = 0;
        for (std::size_t j = 0; j < n; ++j)
          square += row_i[j] * row_i[j];
        for (std::size_t j = 0; j < n; ++j)
          row_i[j] /= std::sqrt(square);
      }
    }
    p.start.assign(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        p.start[i] += p.rotation[i * n + j] * start[j];
    }
  } else {
    p.start = start;
  }
  return p;
}

Problem make_bounded_case(std::size_t index) {
  Problem p = make_case(index);
  const double width = 3 * p.start_radius();
  for (std::size_t i = 0; i < p.n; ++i) {
    p.lower[i] = p.start[i] - width * (i % 2 == 0 ? 1 : 2);
    p.upper[i] = p.start[i] + width * (i % 2 == 0 ? 2 : 1);
  }
  return p;
}

Problem make_large(int kind, std::size_t n) {
  Problem p;
  p.family = rosenbrock_chain + kind;
  p.n = n;
  p.m = p.family == rosenbrock_chain ? 2 * (n - 1) : p.family == variably_dimensioned ? n + 2 : n;
  p.name = (kind == 0   ? "chained Rosenbrock, n "
            : kind == 1 ? "Broyden tridiagonal, n "
            : kind == 2 ? "boundary value, n "
                        : "variably dimensioned, n ") +
           std::to_string(n);
  p.start.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i + 1) / static_cast<double>(n + 1);
    switch (p.family) {
      case rosenbrock_chain:
        p.start[i] = i % 2 == 0 ? -1.2 : 1.0;
        break;
      case broyden_tridiagonal:
        p.start[i] = -1.0;
        break;
      case boundary_value:
        p.start[i] = t * (t - 1);
        break;
      default:
        p.start[i] = 1 - static_cast<double>(i + 1) / static_cast<double>(n);
    }
  }
  p.lower.assign(n, -infinity);
  p.upper.assign(n, infinity);
  return p;
}

Problem make_signed(std::size_t index) {
  Problem p;
  p.family = signed_sum;
  p.n = 2 + index;
  p.m = 2 * p.n;
  p.name = "signed, n " + std::to_string(p.n);
  p.sign.assign(p.m, 1.0);
  std::fill(p.sign.begin() + static_cast<std::ptrdiff_t>(p.n), p.sign.end(), -1.0);
  p.start.assign(p.n, 0.5);
  p.lower.assign(p.n, -2.0);
  p.upper.assign(p.n, 1.0);
  return p;
}

}  // namespace orbicube::bench
