// Problems with known properties and runs of the solver on them, for the tests.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <span>
#include <vector>

#include "projected_gradient/solver.h"
#include "rows.h"
#include "tests/solver_runs.h"

namespace orbicube::test {

using projected_gradient::LineSearch;
using projected_gradient::Method;
using projected_gradient::Options;
using projected_gradient::Request;
using projected_gradient::Result;
using projected_gradient::Solver;
using projected_gradient::Stop;

using Function = std::function<double(std::span<const double> x, std::span<double> gradient)>;

struct Case {
  Constraints constraints;
  std::vector<double> start;
  Function function;
};

struct Run {
  Result result;
  std::vector<double> x;
  std::vector<std::vector<double>> asked;  // every point at which f was requested
};

inline Run drive(Solver& solver, const Function& function) {
  return drive_with_gradient<Run>(solver, solver.size(), function);
}

inline Run run(const Case& problem, const Options& options = {}) {
  const base::Host host;
  Solver solver(problem.constraints.problem(), options, problem.start, host);
  return drive(solver, problem.function);
}

inline double rosenbrock(std::span<const double> x, std::span<double> g) {
  double f = 0;
  std::fill(g.begin(), g.end(), 0.0);
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    const double a = x[i + 1] - x[i] * x[i], b = 1 - x[i];
    f += 100 * a * a + b * b;
    g[i] += -400 * a * x[i] - 2 * b;
    g[i + 1] += 200 * a;
  }
  return f;
}

// Hock and Schittkowski 1 and 2.
inline Case hock_schittkowski(double bound) {
  Case c{Constraints(2), {-2, 1}, rosenbrock};
  c.constraints.lower[1] = bound;
  return c;
}

inline Case hock_schittkowski_53() {
  Case c{Constraints(5, -10, 10), std::vector<double>(5, 2.0), {}};
  c.constraints.add_row({{0, 1}, {1, 3}}, 0);
  c.constraints.add_row({{2, 1}, {3, 1}, {4, -2}}, 0);
  c.constraints.add_row({{1, 1}, {4, -1}}, 0);
  c.function = [](std::span<const double> x, std::span<double> g) {
    const double a = x[0] - x[1], b = x[1] + x[2] - 2, d = x[3] - 1, e = x[4] - 1;
    g[0] = 2 * a;
    g[1] = -2 * a + 2 * b;
    g[2] = 2 * b;
    g[3] = 2 * d;
    g[4] = 2 * e;
    return a * a + b * b + d * d + e * e;
  };
  return c;
}

// 0.5 x'Hx - h'x with H of a given condition and eigenvectors of a random reflection, in a box with random rows.
inline Case random_quadratic(std::uint64_t seed, std::size_t n, std::size_t rows, double condition) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> eigenvalue(n), mirror(n), linear(n);
  double square = 0;
  for (std::size_t j = 0; j < n; ++j) {
    eigenvalue[j] = std::pow(condition, -static_cast<double>(j) / static_cast<double>(n));
    mirror[j] = normal(random);
    linear[j] = normal(random);
    square += mirror[j] * mirror[j];
  }
  Case c{Constraints(n, -1, 1), std::vector<double>(n), {}};
  std::vector<double> inside(n);
  for (std::size_t j = 0; j < n; ++j)
    inside[j] = std::clamp(normal(random), -0.9, 0.9);
  for (std::size_t i = 0; i < rows; ++i) {
    std::vector<std::pair<std::uint32_t, double>> row;
    double rhs = 0;
    for (int k = 0; k < 6; ++k) {
      const auto j = static_cast<std::uint32_t>(random() % n);
      const double a = normal(random);
      row.emplace_back(j, a);
      rhs += a * inside[j];
    }
    c.constraints.add_row(row, rhs);
  }
  c.function = [=](std::span<const double> x, std::span<double> g) {
    const auto reflect = [&](std::vector<double>& v) {
      double along = 0;
      for (std::size_t j = 0; j < n; ++j)
        along += mirror[j] * v[j];
      for (std::size_t j = 0; j < n; ++j)
        v[j] -= 2 * along / square * mirror[j];
    };
    std::vector<double> v(x.begin(), x.end());
    reflect(v);
    for (std::size_t j = 0; j < n; ++j)
      v[j] *= eigenvalue[j];
    reflect(v);
    double f = 0;
    for (std::size_t j = 0; j < n; ++j) {
      g[j] = v[j] - linear[j];
      f += x[j] * (0.5 * v[j] - linear[j]);
    }
    return f;
  };
  return c;
}

// |P(x - g) - x|inf by a projection made afresh.
inline double stationarity(const Case& problem, const std::vector<double>& x) {
  std::vector<double> gradient(x.size()), moved(x.size());
  problem.function(x, gradient);
  for (std::size_t j = 0; j < x.size(); ++j)
    moved[j] = x[j] - gradient[j];
  const Projection projected = project(problem.constraints, moved);
  double worst = 0;
  for (std::size_t j = 0; j < x.size(); ++j)
    worst = std::max(worst, std::abs(projected.x[j] - x[j]));
  return worst;
}

inline Options with(Method method, LineSearch line_search = LineSearch::max_of_last) {
  Options options;
  options.method = method;
  options.line_search = line_search;
  return options;
}

inline const std::vector<Options> every_method = {with(Method::face), with(Method::dissertation),
                                                  with(Method::dissertation, LineSearch::average)};

}  // namespace orbicube::test
