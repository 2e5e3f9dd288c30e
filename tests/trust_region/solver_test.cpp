// Runs on functions with known minima; bounds, signs, scales, starts, given evaluations, noise.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "base/error.h"
#include "runs.h"

using namespace orbicube;
using namespace orbicube::test;

TEST_CASE("Known minima are found, with residuals and without, by both methods") {
  for (const Case& c : every_case()) {
    for (const Method method : {Method::two_radii, Method::dissertation}) {
      CAPTURE(std::string(c.name));
      CAPTURE(c.residuals);
      Options options;
      options.method = method;
      const Run end = run(c, options);
      CHECK(end.result.stop == Stop::converged);
      CHECK(end.result.value <= c.minimum + 1e-9);
      CHECK(end.result.value >= c.minimum - 1e-12);
    }
  }
}

TEST_CASE("Residual structure saves evaluations") {
  std::size_t with = 0, without = 0;
  for (const Case& c : {rosenbrock(), beale(), wood()}) {
    with += run(c).result.evaluations;
    without += run(as_scalar(c)).result.evaluations;
  }
  CHECK(2 * with < without);
}

TEST_CASE("Every number of points from n + 2 to that of full quadratics converges") {
  for (const Case& c : {wood(), as_scalar(wood())}) {
    for (std::uint64_t points = 6; points <= 15; ++points) {
      CAPTURE(points);
      Options options;
      options.points = points;
      options.max_evaluations = 5000;
      const Run end = run(c, options);
      CHECK(end.result.value < 1e-9);
      CHECK(end.result.points <= points);
    }
  }
}

TEST_CASE("No point leaves its bounds by a bit, wherever the minimum lies") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 40; ++trial) {
    Case c = trial % 2 == 0 ? wood() : as_scalar(wood());
    c.lower.resize(4);
    c.upper.resize(4);
    c.scale.resize(4);
    for (std::size_t i = 0; i < 4; ++i) {
      c.lower[i] = uniform(random) * 3 - 1;
      c.upper[i] = c.lower[i] + (random() % 5 == 0 ? 0 : std::pow(10.0, uniform(random)));
      c.scale[i] = std::pow(7.0, uniform(random));
    }
    Options options;
    options.start = static_cast<Start>(trial % 3);
    const Run end = run(c, options);
    bool inside = true;
    for (const auto& x : end.asked)
      inside = inside && within_bounds(c, x);
    CHECK(inside);
    CHECK(end.result.stop != Stop::running);
    // No single unknown can be moved to something better.
    for (std::size_t i = 0; i < 4; ++i) {
      for (const double change : {-1e-3, 1e-3}) {
        std::vector<double> other = end.x;
        other[i] = std::clamp(other[i] + change, c.lower[i], c.upper[i]);
        const std::vector<double> r = c.function(other);
        CHECK((c.residuals > 0 ? sum_of_squares(r) : r[0]) >= end.result.value - 1e-5 * (1 + end.result.value));
      }
    }
  }
}

TEST_CASE("Fixed unknowns stay, and a problem with nothing free takes one evaluation") {
  Case c = wood();
  c.lower = {-3, 0.5, -infinity, -infinity};
  c.upper = {3, 0.5, infinity, infinity};
  const Run end = run(c);
  for (const auto& x : end.asked)
    CHECK(x[1] == 0.5);
  CHECK(end.result.stop == Stop::converged);
  c.lower = c.upper = {1, 1, 1, 1};
  const Run one = run(c);
  CHECK(one.result.evaluations == 1);
  CHECK(one.result.stop == Stop::converged);
  CHECK(one.result.value == 0);
}

TEST_CASE("Signed sums go to the same minimum as their scalar f, and to a bound or target where there is none") {
  // (x - 1)^2 + 4 (y + 1)^2 - (x + y)^2 / 4 - 1: convex although signed; the minimum solves 2 linear equations.
  Case c{"signed",
         {3, 3},
         4,
         [](std::span<const double> x) {
           return std::vector<double>{x[0] - 1, 2 * (x[1] + 1), 0.5 * (x[0] + x[1]), 1.0};
         },
         0,
         {},
         {},
         {1, 1, -1, -1},
         {}};
  // 0.75 x - 0.25 y = 1, -0.25 x + 3.75 y = -4.
  const double determinant = 0.75 * 3.75 - 0.0625, x = (3.75 - 1) / determinant, y = (-3 + 0.25) / determinant;
  c.minimum = (x - 1) * (x - 1) + 4 * (y + 1) * (y + 1) - 0.25 * (x + y) * (x + y) - 1;
  const Run residuals = run(c), scalar = run(as_scalar(c));
  CHECK(residuals.result.value == doctest::Approx(c.minimum).epsilon(1e-12));
  CHECK(scalar.result.value == doctest::Approx(c.minimum).epsilon(1e-12));
  // x^2 - 4 y^2 in a box: a saddle to be left for a side of the box.
  Case saddle{"saddle", {0.2, 0}, 2,      [](std::span<const double> p) {
                return std::vector<double>{p[0], 2 * p[1]}; },
              -36,      {-2, -3}, {2, 2}, {1, -1},
              {}};
  const double found = run(saddle).result.value;
  CHECK((found == doctest::Approx(-36).epsilon(1e-9) || found == doctest::Approx(-16).epsilon(1e-9)));
  saddle.lower.clear();
  saddle.upper.clear();
  Options options;
  options.target = -1e6;
  const Run unbounded = run(saddle, options);
  CHECK(unbounded.result.stop == Stop::target_reached);
  CHECK(unbounded.result.value <= -1e6);
}

TEST_CASE("The points of a cross can be evaluated in any number at once, with the same run") {
  const Case c = as_scalar(wood());
  Options options;
  options.start = Start::cross;
  const Run alone = run(c, options);
  const base::Host host;
  Solver solver(c.problem(), options, c.start, host);
  REQUIRE(solver.step() == Request::need_values);
  CHECK(solver.pending_count() == 9);
  std::vector<std::vector<double>> values;
  for (std::size_t k = 0; k < 9; ++k) {
    const std::span<const double> x = solver.pending().subspan(k * 4, 4);
    CHECK(same_bits({x.begin(), x.end()}, alone.asked[k]));
    values.push_back(c.function(x));
  }
  for (const auto& value : values)
    solver.tell(value);
  drive(solver, c.function);
  CHECK(same_bits({solver.best_point().begin(), solver.best_point().end()}, alone.x));
}

TEST_CASE("Evaluations of before take the place of those of the start") {
  const Case c = wood();
  const Run before = run(c);
  const base::Host host;
  Solver solver(c.problem(), {}, c.start, host);
  std::size_t given = 0;
  double lowest = infinity;
  for (std::size_t k = before.asked.size() / 2; k < before.asked.size(); ++k, ++given) {
    const std::vector<double> r = c.function(before.asked[k]);
    solver.give(before.asked[k], r);
    lowest = std::min(lowest, sum_of_squares(r));
  }
  REQUIRE(given > 5);
  CHECK(solver.result().value == lowest);
  CHECK(solver.result().evaluations == 0);
  drive(solver, c.function);
  CHECK(solver.result().value <= lowest);
  CHECK(solver.result().value < 1e-12);
  CHECK(solver.result().evaluations < before.result.evaluations);
  CHECK_THROWS_AS(solver.give(c.start, c.function(c.start)), base::Error);
}

TEST_CASE("Told of noise, a run ends below its level in less than half of the evaluations") {
  std::uint64_t told = 0, untold = 0;
  for (const bool relative : {false, true}) {
    for (const bool scalar : {false, true}) {
      for (const unsigned seed : {7U, 8U, 9U, 10U}) {
        Case c = scalar ? as_scalar(clipped_distance(6)) : clipped_distance(6);
        const Function exact = c.function;
        const auto value = [&](std::span<const double> x) {
          const std::vector<double> outputs = exact(x);
          return scalar ? outputs[0] : sum_of_squares(outputs);
        };
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> uniform(-1, 1);
        c.function = [&](std::span<const double> x) {
          std::vector<double> outputs = exact(x);
          const double f = value(x), wobble = 1e-3 * uniform(random), noisy = relative ? f * (1 + wobble) : f + wobble;
          for (double& output : outputs)
            output = scalar ? noisy : output * std::sqrt(noisy / f);
          return outputs;
        };
        Options options;
        (relative ? options.noise_relative : options.noise_absolute) = 1e-3;
        const Run end = run(c, options);
        CHECK(end.result.stop == Stop::noise_limit);
        CHECK(value(end.x) < c.minimum + (relative ? 1e-3 * c.minimum : 1e-3));
        told += end.result.evaluations;
        untold += run(c).result.evaluations;
      }
    }
  }
  CHECK(2 * told < untold);
}

TEST_CASE("Where noise or a corner of f ends a run it begins again while that helps, and gets lower") {
  const auto largest = [](Case c) {
    c.residuals = 0;
    c.function = [inner = c.function](std::span<const double> x) {
      double most = 0;
      for (const double r : inner(x))
        most = std::max(most, std::abs(r));
      return std::vector<double>{most};
    };
    return c;
  };
  for (const bool noisy : {true, false}) {
    std::size_t runs = 0, lower = 0;
    for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
      for (const Case& inner : {rosenbrock(), wood(), beale()}) {
        Case c = noisy ? as_scalar(inner) : largest(inner);
        c.start[0] += 0.1 * seed;
        const Function exact = c.function;
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> uniform(-1, 1);
        Options options;
        if (noisy) {
          options.noise_relative = 1e-2;
          c.function = [&](std::span<const double> x) {
            return std::vector<double>{exact(x)[0] * (1 + 1e-2 * uniform(random))};
          };
        }
        const base::Host host;
        Solver solver(c.problem(), options, c.start, host);
        double first = infinity;  // f where the run would have ended
        while (solver.step() != Request::done) {
          if (solver.result().restarts > 0 && first == infinity) first = solver.result().value;
          if (solver.pending_count() > 0) solver.tell(c.function(solver.pending().first(solver.size())));
        }
        const Result end = solver.result();
        if (end.restarts == 0) continue;
        CHECK((end.stop == Stop::noise_limit || end.stop == Stop::resolution_limit || end.stop == Stop::converged));
        CHECK(end.value <= first);
        ++runs;
        lower += end.value < 0.9 * first ? 1 : 0;
      }
    }
    // Some starts are near the minimum, or another local one, at their first end.
    CHECK(runs >= 5);
    CHECK(lower >= 2);
  }
}

TEST_CASE("Restarts go on from the best point and are counted") {
  Options options;
  options.restarts = 2;
  options.max_evaluations = 5000;
  const Run once = run(as_scalar(rosenbrock())), again = run(as_scalar(rosenbrock()), options);
  CHECK(again.result.restarts == 2);
  CHECK(again.result.value <= once.result.value);
  CHECK(again.result.evaluations > once.result.evaluations);
}

TEST_CASE("A scale makes unknowns of different magnitudes alike") {
  Case c = wood();
  const Run plain = run(c);
  const Function inner = c.function;
  // The same function of unknowns a million times larger or smaller: powers of two keep every bit.
  const std::vector<double> factor = {0x1p20, 0x1p-20, 0x1p10, 1};
  c.scale = factor;
  for (std::size_t i = 0; i < 4; ++i)
    c.start[i] *= factor[i];
  c.function = [&](std::span<const double> x) {
    std::vector<double> y(x.begin(), x.end());
    for (std::size_t i = 0; i < 4; ++i)
      y[i] /= factor[i];
    return inner(y);
  };
  const Run scaled = run(c);
  CHECK(scaled.result.evaluations == plain.result.evaluations);
  CHECK(scaled.result.value == plain.result.value);
}

TEST_CASE("Sixty unknowns in residuals converge in a few evaluations an unknown") {
  Case c{"Broyden tridiagonal", std::vector<double>(60, -1.0), 60, {}, 0, {}, {}, {}, {}};
  c.function = [](std::span<const double> x) {
    std::vector<double> r(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      r[i] = (3 - 2 * x[i]) * x[i] - (i > 0 ? x[i - 1] : 0.0) - 2 * (i + 1 < x.size() ? x[i + 1] : 0.0) + 1;
    }
    return r;
  };
  Options options;
  options.target = 1e-10;
  const Run end = run(c, options);
  CHECK(end.result.stop == Stop::target_reached);
  CHECK(end.result.evaluations < 600);
}
