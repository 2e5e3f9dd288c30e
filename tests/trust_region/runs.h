// Functions with known minima and runs of the solver on them, for the tests.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "tests/solver_runs.h"
#include "trust_region/solver.h"

namespace orbicube::test {

using trust_region::Method;
using trust_region::Options;
using trust_region::Problem;
using trust_region::Request;
using trust_region::Result;
using trust_region::Solver;
using trust_region::Start;
using trust_region::Stop;

constexpr double infinity = std::numeric_limits<double>::infinity();

// Outputs at x: f, or the residuals.
using Function = std::function<std::vector<double>(std::span<const double> x)>;

struct Case {
  const char* name;
  std::vector<double> start;
  std::size_t residuals;  // 0: scalar
  Function function;
  double minimum;
  std::vector<double> lower, upper, sign, scale;

  Problem problem() const {
    Problem p;
    p.n = start.size();
    p.residuals = residuals;
    p.lower = lower;
    p.upper = upper;
    p.sign = sign;
    p.scale = scale;
    return p;
  }
};

inline double sum_of_squares(const std::vector<double>& r) {
  double sum = 0;
  for (const double value : r)
    sum += value * value;
  return sum;
}

inline Case rosenbrock() {
  return {"Rosenbrock",
          {-1.2, 1},
          2,
          [](std::span<const double> x) {
            return std::vector<double>{10 * (x[1] - x[0] * x[0]), 1 - x[0]};
          },
          0,
          {},
          {},
          {},
          {}};
}

// More, Garbow, Hillstrom 1981, number 5.
inline Case beale() {
  return {"Beale",
          {1, 1},
          3,
          [](std::span<const double> x) {
            const double y = x[1];
            return std::vector<double>{1.5 - x[0] * (1 - y), 2.25 - x[0] * (1 - y * y), 2.625 - x[0] * (1 - y * y * y)};
          },
          0,
          {},
          {},
          {},
          {}};
}

// More, Garbow, Hillstrom 1981, number 14, whose minimum is 0 at (1, 1, 1, 1).
inline Case wood() {
  return {"Wood",
          {-3, -1, -3, -1},
          6,
          [](std::span<const double> x) {
            return std::vector<double>{10 * (x[1] - x[0] * x[0]),
                                       1 - x[0],
                                       std::sqrt(90.0) * (x[3] - x[2] * x[2]),
                                       1 - x[2],
                                       std::sqrt(10.0) * (x[1] + x[3] - 2),
                                       (x[1] - x[3]) / std::sqrt(10.0)};
          },
          0,
          {},
          {},
          {},
          {}};
}

// sum_i i (x_i - t_i)^2 with t outside of the box for every other unknown: the minimum is at the clipped target.
inline Case clipped_distance(std::size_t n) {
  Case c{"clipped distance", std::vector<double>(n, 0.1), n, {}, 0, {}, {}, {}, {}};
  c.lower.assign(n, -1.0 / 3);
  c.upper.assign(n, 0.7);
  std::vector<double> target(n);
  for (std::size_t i = 0; i < n; ++i) {
    target[i] = i % 3 == 0 ? 1.9 : i % 3 == 1 ? -0.8 : 0.25;
    const double nearest = std::min(std::max(target[i], c.lower[i]), c.upper[i]);
    c.minimum += static_cast<double>(i + 1) * (nearest - target[i]) * (nearest - target[i]);
  }
  c.function = [target](std::span<const double> x) {
    std::vector<double> r(x.size());
    for (std::size_t i = 0; i < x.size(); ++i)
      r[i] = std::sqrt(static_cast<double>(i + 1)) * (x[i] - target[i]);
    return r;
  };
  return c;
}

// The same function without its structure.
inline Case as_scalar(Case c) {
  c.residuals = 0;
  c.function = [inner = c.function, sign = c.sign](std::span<const double> x) {
    const std::vector<double> r = inner(x);
    double sum = 0;
    for (std::size_t i = 0; i < r.size(); ++i)
      sum += (sign.empty() ? 1.0 : sign[i]) * r[i] * r[i];
    return std::vector<double>{sum};
  };
  c.sign.clear();
  return c;
}

inline std::vector<Case> every_case() {
  std::vector<Case> cases = {rosenbrock(), beale(), wood(), clipped_distance(5)};
  const std::size_t count = cases.size();
  for (std::size_t i = 0; i < count; ++i)
    cases.push_back(as_scalar(cases[i]));
  return cases;
}

struct Run {
  Result result;
  std::vector<double> x;
  std::vector<std::vector<double>> asked;  // every point at which f was requested
};

// Fulfils requests until the end, and returns the queried points from here on; gives up where a run would not end.
inline Run drive(Solver& solver, const Function& function) {
  Run run;
  for (std::uint64_t steps = 0;; ++steps) {
    REQUIRE(steps < 1000000);
    const Request request = solver.step();
    if (request == Request::done) break;
    if (request == Request::iteration) continue;
    REQUIRE(solver.pending_count() >= 1);
    const std::span<const double> x = solver.pending().first(solver.size());
    run.asked.emplace_back(x.begin(), x.end());
    solver.tell(function(x));
  }
  run.result = solver.result();
  run.x.assign(solver.best_point().begin(), solver.best_point().end());
  return run;
}

inline Run run(const Case& c, const Options& options = {}) {
  const base::Host host;
  Solver solver(c.problem(), options, c.start, host);
  return drive(solver, c.function);
}

inline bool within_bounds(const Case& c, const std::vector<double>& x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!c.lower.empty() && !(x[i] >= c.lower[i])) return false;
    if (!c.upper.empty() && !(x[i] <= c.upper[i])) return false;
  }
  return true;
}

}  // namespace orbicube::test
