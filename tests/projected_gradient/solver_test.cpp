// Runs to known optima, checked by their optimality conditions; bounds to the bit; how many evaluations they take.
#include <doctest/doctest.h>

#include <algorithm>

#include "runs.h"

using namespace orbicube;
using namespace orbicube::test;

TEST_CASE("Hock and Schittkowski 1, 2 and 53 end at their known minima with every method") {
  for (const Options& options : every_method) {
    const Run one = run(hock_schittkowski(-1.5), options);
    CHECK(one.result.stop == Stop::converged);
    CHECK(one.x[0] == doctest::Approx(1).epsilon(1e-6));
    CHECK(one.x[1] == doctest::Approx(1).epsilon(1e-6));

    const Run two = run(hock_schittkowski(1.5), options);  // has two minima, both with x_2 = 1.5
    CHECK(two.result.stop == Stop::converged);
    CHECK(two.x[1] == 1.5);
    CHECK(std::min(std::abs(two.result.value - 0.0504261879), std::abs(two.result.value - 4.9412293180)) < 1e-8);

    const Run rows = run(hock_schittkowski_53(), options);
    CHECK(rows.result.stop == Stop::converged);
    CHECK(rows.result.value == doctest::Approx(176.0 / 43).epsilon(1e-14));
    const double exact[] = {-33. / 43, 11. / 43, 27. / 43, -5. / 43, 11. / 43};
    for (std::size_t j = 0; j < 5; ++j)
      CHECK(rows.x[j] == doctest::Approx(exact[j]).epsilon(1e-7));
    CHECK(rows.result.equality_residual < 1e-12);
  }
}

TEST_CASE("Random quadratics in a box with rows meet the optimality conditions") {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    CAPTURE(seed);
    const std::size_t n = 5 + seed * 3, rows = seed % 3 == 0 ? 0 : 1 + seed % 7;
    const Case problem = random_quadratic(seed, n, rows, std::pow(10.0, static_cast<double>(seed % 5)));
    const Run end = run(problem);
    REQUIRE(end.result.stop == Stop::converged);
    CHECK(stationarity(problem, end.x) <= 1.01e-8);
    CHECK(problem.constraints.residual(end.x) < 1e-12);
  }
}

TEST_CASE("A quadratic without bounds ends at the solution of its linear system") {
  Case problem = random_quadratic(77, 40, 0, 1e3);
  problem.constraints = Constraints(40);
  const Run end = run(problem);
  REQUIRE(end.result.stop == Stop::converged);
  std::vector<double> gradient(40);
  problem.function(end.x, gradient);
  for (const double g : gradient)
    CHECK(std::abs(g) <= 1e-8);
}

TEST_CASE("The default needs no more evaluations than recorded") {
  // SciPy's L-BFGS-B (m = 10) needs 50 on this; some room for other compilers' rounding.
  Case chain{Constraints(1000, -2, 0.8), std::vector<double>(1000), rosenbrock};
  for (std::size_t i = 0; i < 1000; ++i)
    chain.start[i] = i % 2 == 0 ? -1.2 : 0.8;
  const Run end = run(chain);
  CHECK(end.result.stop == Stop::converged);
  CHECK(end.result.evaluations <= 40);

  // Elastic-plastic torsion on 32 x 32 nodes, c = 5, from zero: 95.
  constexpr std::size_t side = 32;
  constexpr double h = 1.0 / (side + 1);
  Case torsion{Constraints(side * side), std::vector<double>(side * side), {}};
  for (std::size_t k = 0; k < side * side; ++k) {
    const std::size_t i = k / side + 1, j = k % side + 1;
    torsion.constraints.upper[k] = static_cast<double>(std::min({i, j, side + 1 - i, side + 1 - j})) * h;
    torsion.constraints.lower[k] = -torsion.constraints.upper[k];
  }
  torsion.function = [&](std::span<const double> x, std::span<double> g) {
    double f = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const std::size_t i = k / side, j = k % side;
      const double neighbors = (j > 0 ? x[k - 1] : 0) + (j + 1 < side ? x[k + 1] : 0) + (i > 0 ? x[k - side] : 0) +
                               (i + 1 < side ? x[k + side] : 0);
      g[k] = 4 * x[k] - neighbors - 5 * h * h;
      f += 0.5 * x[k] * (g[k] - 5 * h * h);
    }
    return f;
  };
  const Run bent = run(torsion);
  CHECK(bent.result.stop == Stop::converged);
  CHECK(bent.result.value == doctest::Approx(-0.417523467707).epsilon(1e-11));
  CHECK(bent.result.evaluations <= 95);
}

TEST_CASE("The dual of a support vector machine takes few gradients") {
  // 200 points of two overlapping clouds in the plane, Gaussian kernel, C = 10: one row, a box, nearly singular
  // Hessian.
  constexpr std::size_t n = 200;
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::vector<double> point(2 * n), label(n), q(n * n);
  Case dual{Constraints(n, 0, 10), std::vector<double>(n), {}};
  std::vector<std::pair<std::uint32_t, double>> row;
  for (std::size_t i = 0; i < n; ++i) {
    label[i] = i % 2 == 0 ? 1 : -1;
    for (std::size_t k = 0; k < 2; ++k)
      point[2 * i + k] = normal(random) + 0.5 * label[i];
    row.emplace_back(static_cast<std::uint32_t>(i), label[i]);
  }
  dual.constraints.add_row(row, 0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      const double x = point[2 * i] - point[2 * j], y = point[2 * i + 1] - point[2 * j + 1];
      q[i * n + j] = label[i] * label[j] * std::exp(-(x * x + y * y) / 2);
    }
  }
  dual.function = [&](std::span<const double> x, std::span<double> g) {
    double f = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double sum = 0;
      for (std::size_t j = 0; j < n; ++j)
        sum += q[i * n + j] * x[j];
      g[i] = sum - 1;
      f += x[i] * (0.5 * sum - 1);
    }
    return f;
  };
  const Run end = run(dual);
  CHECK(end.result.stop == Stop::converged);
  CHECK(end.result.evaluations <= 1000);
  CHECK(stationarity(dual, end.x) <= 1.01e-8);
  CHECK(dual.constraints.residual(end.x) < 1e-12);
  MESSAGE(end.result.evaluations << " gradients");
}

TEST_CASE("Every point that f is asked at is within its bounds to the bit and on the rows to rounding") {
  for (const Options& options : every_method) {
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
      const Case problem = random_quadratic(100 + seed, 30, seed, 100);
      const Run end = run(problem, options);
      REQUIRE(end.result.stop == Stop::converged);
      for (const std::vector<double>& x : end.asked) {
        CHECK(problem.constraints.within_bounds(x));
        CHECK(problem.constraints.residual(x) < 1e-12);
      }
    }
  }
}

TEST_CASE("A start outside is projected, and unknowns with equal bounds never move") {
  Case problem = random_quadratic(5, 12, 2, 10);
  problem.start.assign(12, 50.0);
  problem.constraints = Constraints(12, -1, 1);
  problem.constraints.lower[3] = problem.constraints.upper[3] = 0.1 + 0.2;
  const Run end = run(problem);
  CHECK(end.result.stop == Stop::converged);
  for (const auto& x : end.asked)
    CHECK(x[3] == 0.1 + 0.2);
  CHECK(end.asked.front()[0] == 1.0);
}

TEST_CASE("The multipliers at the end are those of the Lagrangian") {
  const Case problem = hock_schittkowski_53();
  const base::Host host;
  Solver solver(problem.constraints.problem(), {}, problem.start, host);
  drive(solver, problem.function);
  std::vector<double> multipliers(3), gradient(5);
  solver.copy_multipliers(multipliers);
  const std::vector<double> x(solver.best_point().begin(), solver.best_point().end());
  problem.function(x, gradient);
  const std::vector<double> pull = problem.constraints.transposed_times(multipliers);
  for (std::size_t j = 0; j < 5; ++j)
    CHECK(std::abs(gradient[j] - pull[j]) < 1e-7);
}

TEST_CASE("A projection of the caller's is enough: the unit ball") {
  // min |x - c|^2 over the unit ball ends at c / |c|.
  const std::vector<double> centre = {3, -4, 12};
  for (const Options& options : every_method) {
    projected_gradient::Problem problem;
    problem.n = 3;
    problem.project = [](const double* y, double* x) {
      const double length = std::hypot(y[0], y[1], y[2]);
      for (int j = 0; j < 3; ++j)
        x[j] = length > 1 ? y[j] / length : y[j];
      return true;
    };
    const base::Host host;
    Solver solver(problem, options, std::vector<double>{0, 5, 0}, host);
    drive(solver, [&](std::span<const double> x, std::span<double> g) {
      double f = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        g[j] = x[j] - centre[j];
        f += 0.5 * g[j] * g[j];
      }
      return f;
    });
    CHECK(solver.result().stop == Stop::converged);
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(solver.best_point()[j] == doctest::Approx(centre[j] / 13).epsilon(1e-8));
  }
}

TEST_CASE("A negative curvature in a box ends at a corner, and f unbounded below ends all the same") {
  Case corner{Constraints(3, -1, 2), {0.1, 0.2, -0.3}, [](std::span<const double> x, std::span<double> g) {
                double f = 0;
                for (std::size_t j = 0; j < 3; ++j) {
                  f -= x[j] * x[j];
                  g[j] = -2 * x[j];
                }
                return f;
              }};
  Case endless = corner;
  endless.constraints = Constraints(3);
  for (const Options& options : every_method) {
    const Run end = run(corner, options);
    CHECK(end.result.stop == Stop::converged);
    for (const double x : end.x)
      CHECK((x == -1 || x == 2));
    Options few = options;
    few.max_evaluations = 2000;
    CHECK(run(endless, few).result.value < -1e6);
  }
}
