// Runs to known optima, checked by their optimality conditions; bounds to the bit; failures of f at any evaluation;
// saving at any evaluation; ends of a run.
#include "projected_gradient/solver.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>
#include <thread>

#include "base/error.h"
#include "rows.h"

using namespace orbicube;
using namespace orbicube::test;
using projected_gradient::LineSearch;
using projected_gradient::Method;
using projected_gradient::Options;
using projected_gradient::Request;
using projected_gradient::Result;
using projected_gradient::Solver;
using projected_gradient::Stop;

namespace {

using Function = std::function<double(std::span<const double> x, std::span<double> gradient)>;

struct Case {
  Constraints constraints;
  std::vector<double> start;
  Function function;
};

struct Run {
  Result result;
  std::vector<double> x;
  std::vector<std::vector<double>> asked;  // every point at which f was asked for
};

// Answers requests until the end; gives up where a run would not end.
void drive(Solver& solver, const Function& function, std::vector<std::vector<double>>* asked = nullptr) {
  std::vector<double> gradient(solver.size());
  for (std::uint64_t steps = 0;; ++steps) {
    REQUIRE(steps < 1000000);
    const Request request = solver.step();
    if (request == Request::done) return;
    if (request == Request::iteration) continue;
    if (asked != nullptr) asked->emplace_back(solver.point().begin(), solver.point().end());
    const double value = function(solver.point(), gradient);
    solver.tell(value, gradient);
  }
}

Run run(const Case& problem, const Options& options = {}) {
  const base::Host host;
  Solver solver(problem.constraints.problem(), options, problem.start, host);
  Run result;
  drive(solver, problem.function, &result.asked);
  result.result = solver.result();
  result.x.assign(solver.best_point().begin(), solver.best_point().end());
  return result;
}

double rosenbrock(std::span<const double> x, std::span<double> g) {
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
Case hock_schittkowski(double bound) {
  Case c{Constraints(2), {-2, 1}, rosenbrock};
  c.constraints.lower[1] = bound;
  return c;
}

Case hock_schittkowski_53() {
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
Case random_quadratic(std::uint64_t seed, std::size_t n, std::size_t rows, double condition) {
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
double stationarity(const Case& problem, const std::vector<double>& x) {
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

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

Options with(Method method, LineSearch line_search = LineSearch::largest_of_last) {
  Options options;
  options.method = method;
  options.line_search = line_search;
  return options;
}

const std::vector<Options> every_method = {with(Method::face), with(Method::seed),
                                           with(Method::seed, LineSearch::average)};

}  // namespace

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
  // SciPy's L-BFGS-B (m = 10) needs 48 and 50 on these; some room for other compilers' rounding.
  CHECK(run(hock_schittkowski(-1.5)).result.evaluations <= 48);
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
      const double neighbours = (j > 0 ? x[k - 1] : 0) + (j + 1 < side ? x[k + 1] : 0) + (i > 0 ? x[k - side] : 0) +
                                (i + 1 < side ? x[k + side] : 0);
      g[k] = 4 * x[k] - neighbours - 5 * h * h;
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

TEST_CASE("A projection that fails ends the run, saying so") {
  projected_gradient::Problem problem;
  problem.n = 1;
  int left = 4;
  problem.project = [&](const double* y, double* x) {
    x[0] = y[0];
    return --left > 0;
  };
  const base::Host host;
  Solver solver(problem, {}, std::vector<double>{3}, host);
  drive(solver, [](std::span<const double> x, std::span<double> g) {
    g[0] = x[0];
    return 0.5 * x[0] * x[0];
  });
  CHECK(solver.result().stop == Stop::projection_failed);
}

TEST_CASE("Saved at each evaluation and loaded into a new solver, a run goes on with the same bits") {
  for (const Options& options : every_method) {
    for (const Case& problem : {hock_schittkowski(1.5), hock_schittkowski_53(), random_quadratic(9, 25, 1, 100)}) {
      const Run whole = run(problem, options);
      const base::Host host;
      Solver solver(problem.constraints.problem(), options, problem.start, host);
      std::vector<double> gradient(solver.size());
      std::size_t evaluation = 0;
      std::vector<std::byte> blob;
      for (Request request; (request = solver.step()) != Request::done;) {
        for (const bool told : {false, true}) {  // while a request waits, and after it was answered
          if (request != Request::need_value_and_gradient) continue;
          if (told) solver.tell(problem.function(solver.point(), gradient), gradient);
          blob.resize(solver.save_size());
          solver.save(blob);
          Solver loaded(problem.constraints.problem(), Solver::options_of(blob), {}, host);
          loaded.load(blob);
          std::vector<std::vector<double>> asked;
          drive(loaded, problem.function, &asked);
          // The points asked for are the rest of the whole run's, and so is the end.
          const std::size_t first = evaluation + (told ? 1 : 0);
          REQUIRE(asked.size() == whole.asked.size() - first);
          bool same = true;
          for (std::size_t k = 0; k < asked.size(); ++k)
            same = same && same_bits(asked[k], whole.asked[first + k]);
          CHECK(same);
          CHECK(same_bits({loaded.best_point().begin(), loaded.best_point().end()}, whole.x));
          CHECK(loaded.result().evaluations == whole.result.evaluations);
          CHECK(loaded.result().stop == whole.result.stop);
        }
        if (request == Request::need_value_and_gradient) ++evaluation;
      }
    }
  }
}

TEST_CASE("A damaged or foreign blob is refused") {
  const Case problem = hock_schittkowski_53();
  const base::Host host;
  Solver solver(problem.constraints.problem(), {}, problem.start, host);
  std::vector<std::byte> blob(solver.save_size());
  solver.save(blob);
  const auto refuses = [&](const std::vector<std::byte>& bytes, const Constraints& constraints) {
    const auto load = [&] {
      Solver loaded(constraints.problem(), Solver::options_of(bytes), {}, host);
      loaded.load(bytes);
    };
    CHECK_THROWS_AS(load(), base::Error);
  };
  for (std::size_t i = 0; i < blob.size(); i += 7) {
    std::vector<std::byte> damaged = blob;
    damaged[i] ^= std::byte{0x10};
    refuses(damaged, problem.constraints);
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{10}, blob.size() - 1}) {
    refuses({blob.begin(), blob.begin() + static_cast<std::ptrdiff_t>(size)}, problem.constraints);
  }
  Constraints other = problem.constraints;
  other.rhs[0] = 0.1;
  refuses(blob, other);
}

TEST_CASE("A value that is not finite at any one evaluation does not keep the run from its end") {
  const double nan = std::nan("");
  for (const Options& options : every_method) {
    for (const Case& problem : {hock_schittkowski(1.5), hock_schittkowski_53(), random_quadratic(9, 25, 1, 100)}) {
      const std::size_t count = run(problem, options).asked.size();
      for (std::size_t bad = 0; bad < count; ++bad) {
        for (const int kind : {0, 1, 2}) {
          CAPTURE(bad);
          CAPTURE(kind);
          std::size_t evaluation = 0;
          Case spoiled = problem;
          spoiled.function = [&](std::span<const double> x, std::span<double> g) {
            const double f = problem.function(x, g);
            if (evaluation++ != bad) return f;
            if (kind == 2) g[g.size() - 1] = nan;
            return kind == 0 ? nan : kind == 1 ? -infinity : f;
          };
          const Run end = run(spoiled, options);
          CHECK(end.result.failed_evaluations == 1);
          if (bad == 0) {
            CHECK(end.result.stop == Stop::evaluation_failed);
            CHECK(std::isnan(end.result.value));
          } else {
            CHECK(end.result.stop == Stop::converged);
            CHECK(stationarity(problem, end.x) <= 1.01e-8);
          }
          CHECK(problem.constraints.within_bounds(end.x));
        }
      }
    }
  }
}

TEST_CASE("When f fails from some evaluation on, the run ends with its best point") {
  const Case problem = hock_schittkowski(-1.5);
  for (const Options& options : every_method) {
    for (std::size_t last = 1; last < 20; ++last) {
      std::size_t evaluation = 0;
      double best = infinity;
      Case spoiled = problem;
      spoiled.function = [&](std::span<const double> x, std::span<double> g) {
        if (evaluation++ >= last) return std::nan("");
        const double f = problem.function(x, g);
        best = std::min(best, f);
        return f;
      };
      const Run end = run(spoiled, options);
      CHECK(end.result.stop == Stop::evaluation_failed);
      CHECK(end.result.value == best);
      std::vector<double> gradient(2);
      CHECK(problem.function(end.x, gradient) == best);
      CHECK(end.result.evaluations < 200);
    }
  }
}

TEST_CASE("Budgets and targets end a run, and the best point is known at any time") {
  const Case problem = hock_schittkowski(-1.5);
  for (Options options : every_method) {
    options.max_evaluations = 7;
    const Run few = run(problem, options);
    CHECK(few.result.stop == Stop::evaluation_budget);
    CHECK(few.result.evaluations == 7);
    double best = infinity;
    std::vector<double> gradient(2);
    for (const auto& x : few.asked)
      best = std::min(best, problem.function(x, gradient));
    CHECK(few.result.value == best);

    options.max_evaluations = 1000;
    options.max_iterations = 5;
    CHECK(run(problem, options).result.stop == Stop::iteration_budget);
    options.max_iterations = 1000;
    options.target = 1.0;
    const Run target = run(problem, options);
    CHECK(target.result.stop == Stop::target_reached);
    CHECK(target.result.value <= 1.0);
  }
}

TEST_CASE("A tolerance below what rounding allows ends as stalled, close to the solution") {
  Case problem = random_quadratic(3, 30, 2, 1e4);
  const Function inner = problem.function;
  problem.function = [&](std::span<const double> x, std::span<double> g) { return inner(x, g) + 1e3; };
  for (Options options : every_method) {
    options.gradient_tolerance = 0;
    options.max_evaluations = 100000;
    const Run end = run(problem, options);
    CHECK((end.result.stop == Stop::stalled || end.result.stop == Stop::converged));
    CHECK(stationarity(problem, end.x) < (options.method == Method::face ? 1e-9 : 1e-4));
  }
}

TEST_CASE("Contradicting constraints end a run at its first step with a certificate") {
  Case problem = hock_schittkowski_53();
  problem.constraints.add_row({{0, 1}}, 11);
  const base::Host host;
  Solver solver(problem.constraints.problem(), {}, problem.start, host);
  CHECK(solver.step() == Request::done);
  CHECK(solver.result().stop == Stop::infeasible);
  CHECK(solver.result().certificate_gap > 0);
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

TEST_CASE("Sixty-four runs at once on threads end in the bits of one alone") {
  const Case problem = random_quadratic(21, 60, 4, 1e4);
  const Run alone = run(problem);
  std::vector<Run> runs(64);
  {
    std::vector<std::jthread> threads;
    for (Run& slot : runs)
      threads.emplace_back([&] { slot = run(problem); });
  }
  for (const Run& other : runs) {
    CHECK(same_bits(other.x, alone.x));
    CHECK(other.result.evaluations == alone.result.evaluations);
  }
}

TEST_CASE("A host that cancels gets the best point so far") {
  const Case problem = random_quadratic(22, 60, 4, 1e4);
  base::Host host;
  bool stop = false;
  host.on_progress = [&](const base::Progress&) { return !stop; };
  Solver solver(problem.constraints.problem(), {}, problem.start, host);
  std::vector<double> gradient(60);
  double best = infinity;
  for (int evaluation = 0; evaluation < 10;) {
    if (solver.step() != Request::need_value_and_gradient) continue;
    ++evaluation;
    const double f = problem.function(solver.point(), gradient);
    best = std::min(best, f);
    solver.tell(f, gradient);
  }
  stop = true;
  // Reports are passed on every 20 ms at most.
  for (int step = 0; step < 1000 && solver.step() != Request::done; ++step) {
    if (solver.step() == Request::need_value_and_gradient) solver.tell(best + 1, gradient);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  CHECK(solver.result().stop == Stop::cancelled);
  CHECK(solver.result().value == best);
  CHECK(solver.step() == Request::done);
}

TEST_CASE("What is not asked for cannot be told") {
  const Case problem = hock_schittkowski(1.5);
  const base::Host host;
  Solver solver(problem.constraints.problem(), {}, problem.start, host);
  const std::vector<double> gradient(2);
  CHECK_THROWS_AS(solver.tell(1, gradient), base::Error);
  CHECK(solver.step() == Request::need_value_and_gradient);
  CHECK(solver.step() == Request::need_value_and_gradient);
  CHECK_THROWS_AS(solver.tell(1, std::vector<double>(3)), base::Error);
  solver.tell(1, gradient);
  CHECK_THROWS_AS(solver.tell(1, gradient), base::Error);
}
