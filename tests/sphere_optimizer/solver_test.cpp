// All spheres at once: known optima, certificates, lengths, and how the methods compare.
#include "sphere_optimizer/solver.h"

#include "base/error.h"
#include "lattice.h"
#include "problems.h"
#include "sphere_optimizer/spheres.h"

using namespace orbicube;
using namespace orbicube::test;
using namespace orbicube::sphere_optimizer;

TEST_CASE("Charges on the sphere reach the known least energies") {
  // Wales and Ulker 2006; from these starts there is no other local minimum in the way.
  const std::pair<std::size_t, double> known[] = {
      {2, 0.5}, {4, 3.674234614}, {12, 49.165253058}, {24, 223.347074052}, {32, 412.261274651}, {50, 1055.182314726}};
  for (const auto& row : known) {
    const std::size_t count = row.first;
    const double energy = row.second;
    for (const Method method : {Method::limited_memory, Method::barzilai_borwein, Method::truncated_newton}) {
      const Problem problem = thomson(count, 1);
      const Run end = run(problem, with(method));
      CAPTURE(count);
      CHECK(end.result.stop == Stop::converged);
      CHECK(std::abs(end.result.value - energy) < 1e-9 * energy);
      CHECK(stationarity(problem, end.x) < 1.01e-8);
    }
  }
}

TEST_CASE("Rayleigh quotients end at the least eigenvalue with its eigenvector") {
  const std::size_t n = 60;
  const double pi = std::acos(-1.0), half = std::sin(pi / (2 * (n + 1)));
  for (const Method method : {Method::limited_memory, Method::barzilai_borwein, Method::truncated_newton}) {
    const Run end = run(laplacian(n, 3), with(method));
    CHECK(end.result.stop == Stop::converged);
    // The quotient's error is the square of the gradient over the gap.
    CHECK(std::abs(end.result.value - 4 * half * half) < 1e-14);
    double along = 0;
    for (std::size_t i = 0; i < n; ++i)
      along += end.x[i] * std::sin(pi * static_cast<double>(i + 1) / (n + 1)) * std::sqrt(2.0 / (n + 1));
    CHECK(std::abs(std::abs(along) - 1) < 1e-12);
  }
}

TEST_CASE("The relaxation of max-cut is solved to a certificate below 1e-6") {
  const std::size_t side = 10, n = side * side, d = 16;
  const Problem problem = maximum_cut(side, d, 5);
  const Run end = run(problem);
  REQUIRE(end.result.stop == Stop::converged);
  // S = W - diag(x_i . (W X)_i) without an eigenvalue below -e proves that no value is lower by more than n e.
  const std::vector<double> weights = torus_weights(side, 5);
  std::vector<double> s(n * n), gradient(n * d);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t along = 0; along < 2; ++along) {
      const std::size_t j = torus_neighbor(side, i, along);
      s[i * n + j] += weights[2 * i + along];
      s[j * n + i] += weights[2 * i + along];
    }
  }
  problem.function(end.x, gradient);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < d; ++k)
      s[i * n + i] -= 0.5 * end.x[i * d + k] * gradient[i * d + k];
  }
  const double allowed = 1e-6 * std::abs(end.result.value) / static_cast<double>(n);
  CHECK(no_eigenvalue_below(s, n, allowed));
  // A value that is not optimal has no certificate: the test can fail.
  Options few;
  few.max_evaluations = 8;
  CHECK(run(problem, few).result.value > end.result.value + 1);
}

TEST_CASE("Blocks have length 1 to 2 units of the last place wherever f is requested, in any dimension") {
  for (const Method method : every_method) {
    for (const Problem& problem : {thomson(20, 2), laplacian(500, 2), maximum_cut(6, 2, 1), maximum_cut(6, 4, 1),
                                   maximum_cut(6, 7, 1), maximum_cut(4, 64, 1)}) {
      Options options = with(method);
      options.max_evaluations = 120;
      const Run end = run(problem, options);
      double worst = length_error(problem.shape, end.x);
      for (const auto& x : end.asked)
        worst = std::max(worst, length_error(problem.shape, x));
      CHECK(worst <= 2);
    }
  }
}

TEST_CASE(
    "The default needs fewer evaluations than Barzilai-Borwein, and five times fewer than halving great circles") {
  for (const Problem& problem : {thomson(50, 1), maximum_cut(10, 12, 2), laplacian(60, 1)}) {
    const Run memory = run(problem, with(Method::limited_memory, 1e-6));
    const Run steps = run(problem, with(Method::barzilai_borwein, 1e-6));
    Options halving = with(Method::great_circle, 1e-6);
    halving.max_evaluations = 5 * memory.result.evaluations;
    REQUIRE(memory.result.stop == Stop::converged);
    REQUIRE(steps.result.stop == Stop::converged);
    CHECK(memory.result.evaluations < steps.result.evaluations);
    CHECK(run(problem, halving).result.stop == Stop::evaluation_budget);
  }
}

TEST_CASE("Algorithm 2 as printed descends, from the same start to the same kind of point") {
  const Problem problem = thomson(12, 4);
  const Run mended = run(problem, with(Method::great_circle, 1e-5)),
            printed = run(problem, with(Method::dissertation, 1e-5));
  CHECK(mended.result.stop == Stop::converged);
  CHECK(std::abs(mended.result.value - 49.165253058) < 1e-8);
  CHECK((printed.result.stop == Stop::converged || printed.result.stop == Stop::stalled));
  CHECK(printed.result.value < 49.2);
}

TEST_CASE("What the printed Algorithm 2 does where G.p is small and positive is mended") {
  // f = a.x on a circle: at angle t from -a the printed first step is 2 asin(cos t), nothing at t = 90 degrees.
  Problem problem{{1, 2}, {0, 0}, [](std::span<const double> x, std::span<double> g) {
                    g[0] = 1;
                    g[1] = 0;
                    return x[0];
                  }};
  problem.start = {1e-9, 1};
  Options one = with(Method::dissertation);
  one.max_evaluations = 2;
  CHECK(run(problem, one).result.value > -1e-8);
  one.method = Method::great_circle;
  CHECK(run(problem, one).result.value < -0.5);
  CHECK(run(problem, with(Method::great_circle)).result.value == doctest::Approx(-1).epsilon(1e-15));
}

TEST_CASE("A gradient and the same with any radial part lead to the same point; but for the default by the same path") {
  const Problem plain = thomson(12, 6);
  for (const double part : {-40.0, 3.0, 40.0}) {
    Problem radial = plain;
    radial.function = [=, inner = plain.function](std::span<const double> x, std::span<double> g) {
      const double value = inner(x, g);
      for (std::size_t i = 0; i < x.size(); ++i)
        g[i] += part * x[i];
      return value;
    };
    for (const Method method : {Method::barzilai_borwein, Method::great_circle}) {
      Options options = with(method);
      options.max_evaluations = 15;  // rounding grows along the way
      const Run a = run(plain, options), b = run(radial, options);
      CHECK(std::abs(a.result.value - b.result.value) < 1e-9);
    }
    const Run end = run(radial);
    CHECK(end.result.stop == Stop::converged);
    CHECK(std::abs(end.result.value - 49.165253058) < 1e-8);
  }
}

TEST_CASE("Rotating every sphere alike rotates the path") {
  const Problem problem = thomson(12, 7);
  Problem turned = problem;
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (std::size_t i = 0; i < 12; ++i) {
    const double x = problem.start[3 * i], y = problem.start[3 * i + 1];
    turned.start[3 * i] = c * x - s * y;
    turned.start[3 * i + 1] = s * x + c * y;
  }
  for (const Method method : every_method) {
    Options options = with(method);
    options.max_evaluations = 15;
    const Run a = run(problem, options), b = run(turned, options);
    // Rounding is divided by the length of the differences that truncated_newton takes.
    const double allowed = method == Method::truncated_newton ? 1e-7 : 1e-9;
    for (std::size_t i = 0; i < 12; ++i) {
      CHECK(std::abs(b.x[3 * i] - (c * a.x[3 * i] - s * a.x[3 * i + 1])) < allowed);
      CHECK(std::abs(b.x[3 * i + 2] - a.x[3 * i + 2]) < allowed);
    }
  }
}

TEST_CASE("Great circles and parallel transport keep lengths, angles and derivatives") {
  const FixedDimension<4> four;
  std::vector<double> numbers = normal_numbers(16, 8);
  double *x = numbers.data(), *v = x + 4, *w = x + 8, *out = x + 12;
  REQUIRE(normalize(four, x));
  make_tangent(four, x, v);
  make_tangent(four, x, w);
  double velocity[4], ahead[4], behind[4], unused[4], carried[4];
  for (const double length : {0.0, 1e-9, 0.3, 1.0}) {
    move(four, x, v, length, out, velocity);
    move(four, x, v, length + 1e-5, ahead, unused);
    move(four, x, v, length - 1e-5, behind, unused);
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(std::abs((ahead[k] - behind[k]) / 2e-5 - velocity[k]) < 1e-8);
    std::copy(w, w + 4, carried);
    transport(four, x, out, carried);
    CHECK(std::abs(block_dot(four, carried, out)) < 8 * ulp);
    CHECK(std::abs(block_dot(four, carried, carried) - block_dot(four, w, w)) < 20 * ulp * block_dot(four, w, w));
    std::copy(v, v + 4, carried);
    transport(four, x, out, carried);
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(std::abs(carried[k] - velocity[k]) < 20 * ulp);
  }
  double nothing[4] = {0, 0, 0, 0};
  CHECK(!normalize(four, nothing));
}

TEST_CASE("Gradients of 1e-12 are reached, also where the terms of the value cancel") {
  // The lattice's minimum is 0, from terms of 1: its value is rounding errors long before the end.
  constexpr std::size_t side = 8, count = side * side * side;
  Problem lattice{{count, 4}, normal_numbers(4 * count, 10), [](std::span<const double> x, std::span<double> g) {
                    return LatticeEnergy(side, x).all(g);
                  }};
  for (std::size_t i = 0; i < count; ++i)
    lattice.start[4 * i] += 1.5;
  for (const Problem& problem : {thomson(50, 1), laplacian(60, 1), maximum_cut(10, 16, 5), lattice}) {
    for (const Method method : {Method::limited_memory, Method::truncated_newton}) {
      const Run end = run(problem, with(method, 1e-12));
      CHECK(end.result.stop == Stop::converged);
      CHECK(end.result.gradient_norm <= 1e-12);
    }
  }
}

TEST_CASE("Arguments that cannot be are refused") {
  const base::Host host;
  const auto refuses = [&](const Shape& shape, const Options& options, const std::vector<double>& start) {
    CHECK_THROWS_AS(Solver(shape, options, start, host), base::Error);
  };
  refuses({0, 3}, {}, {});
  refuses({1, 1}, {}, {1});
  refuses({1, 3}, {}, {0, 0, 0});
  refuses({1, 3}, {}, {1, std::nan(""), 0});
  refuses({1, 3}, {}, {1, 0});
  refuses({std::size_t{1} << 62, 16}, {}, {});
  Options options;
  options.memory = 0;
  refuses({1, 3}, options, {1, 0, 0});
  options = {};
  options.history = 0;
  refuses({1, 3}, options, {1, 0, 0});
  options = {};
  options.gradient_tolerance = -1;
  refuses({1, 3}, options, {1, 0, 0});
  options = {};
  options.method = static_cast<Method>(5);
  refuses({1, 3}, options, {1, 0, 0});
}
