// Quadratic functions, whose minima along steps take no evaluation; and functions that are quadratic in parts.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>

#include "runs.h"

using namespace orbicube;
using namespace orbicube::test;

namespace {

// 0.5 sum w_j (x_j - 1)^2 with as many different w, from 1 on, as `groups`.
Case grouped_squares(std::size_t n, std::size_t groups) {
  Case c{Constraints(n), std::vector<double>(n), {}};
  for (std::size_t j = 0; j < n; ++j)
    c.start[j] = 2 + std::sin(static_cast<double>(3 * j + 1));
  c.function = [=](std::span<const double> x, std::span<double> g) {
    double f = 1;
    for (std::size_t j = 0; j < n; ++j) {
      const double away = x[j] - 1;
      g[j] = static_cast<double>(1 + 7 * (j % groups)) * away;
      f += 0.5 * g[j] * away;
    }
    return f;
  };
  return c;
}

// A strictly convex quadratic, and squares of what lies beyond planes, none of which holds at the start.
Case hinges(std::size_t n, double weight) {
  Case c{Constraints(n, -50, 50), std::vector<double>(n, -20.0), {}};
  c.function = [=](std::span<const double> x, std::span<double> g) {
    double f = 0;
    for (std::size_t j = 0; j < n; ++j) {
      const double scale = 1 + static_cast<double>(j % 10), away = x[j] - 3;
      const double beyond = std::max(0.0, x[j] - 1);
      g[j] = scale * away + 2 * weight * beyond;
      f += 0.5 * scale * away * away + weight * beyond * beyond;
    }
    return f;
  };
  return c;
}

}  // namespace

TEST_CASE("A quadratic takes as many evaluations as conjugate gradients do, and a few to be known as one") {
  // Exact steps of conjugate gradients end after as many as there are different curvatures. Two searches before, of
  // which the first may take two trials.
  constexpr std::uint64_t to_be_known = 4, last = 1;
  for (const std::size_t groups : std::array<std::size_t, 3>{2, 4, 6}) {
    CAPTURE(groups);
    const Run end = run(grouped_squares(300, groups));
    CHECK(end.result.stop == Stop::converged);
    CHECK(end.result.evaluations <= groups + to_be_known + last);
  }
}

TEST_CASE("A run of a quadratic ends at a point where f was evaluated, with the value there") {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    CAPTURE(seed);
    const std::size_t rows = seed % 4;
    const Case problem = random_quadratic(seed, 60, rows, std::pow(10.0, static_cast<double>(seed % 5)));
    Options options;
    // Also where the run ends before its tolerance.
    if (seed % 2 == 1) options.max_evaluations = 5 + seed;
    const Run end = run(problem, options);
    CHECK(std::find(end.asked.begin(), end.asked.end(), end.x) != end.asked.end());
    std::vector<double> gradient(60);
    CHECK(problem.function(end.x, gradient) == end.result.value);
    if (end.result.stop == Stop::converged) CHECK(stationarity(problem, end.x) <= 1.01e-8);
  }
}

TEST_CASE("A function that is quadratic around its start only ends at its minimum") {
  for (const double weight : {0.1, 10.0, 1000.0, 100000.0}) {
    for (const std::size_t n : std::array<std::size_t, 3>{5, 50, 500}) {
      CAPTURE(weight);
      CAPTURE(n);
      const Run end = run(hinges(n, weight));
      CHECK(end.result.stop == Stop::converged);
      for (std::size_t j = 0; j < n; ++j) {
        // Where scale (x - 3) + 2 weight (x - 1) is 0.
        const double scale = 1 + static_cast<double>(j % 10);
        CHECK(end.x[j] == doctest::Approx((3 * scale + 2 * weight) / (scale + 2 * weight)).epsilon(1e-8));
      }
    }
  }
}
