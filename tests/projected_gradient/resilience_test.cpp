// What may go wrong or be cut short: saving at any evaluation, values that are not finite, budgets, rounding, threads,
// cancelling.
#include <doctest/doctest.h>

#include "base/error.h"
#include "runs.h"

using namespace orbicube;
using namespace orbicube::test;

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
      const base::Host host;
      Solver solver(problem.constraints.problem(), options, problem.start, host);
      std::vector<double> gradient(solver.size());
      check_resuming(
          solver, run(problem, options),
          [&](Solver& asking) { asking.tell(problem.function(asking.point(), gradient), gradient); },
          [&](std::span<const std::byte> blob) {
            Solver loaded(problem.constraints.problem(), Solver::options_of(blob), {}, host);
            loaded.load(blob);
            return drive(loaded, problem.function);
          });
    }
  }
}

TEST_CASE("A damaged or foreign blob is refused") {
  const Case problem = hock_schittkowski_53();
  const base::Host host;
  Solver solver(problem.constraints.problem(), {}, problem.start, host);
  std::vector<std::byte> blob(solver.save_size());
  solver.save(blob);
  const auto load = [&](const std::vector<std::byte>& bytes, const Constraints& constraints) {
    Solver loaded(constraints.problem(), Solver::options_of(bytes), {}, host);
    loaded.load(bytes);
  };
  check_damaged_blobs(blob, [&](const auto& bytes) { load(bytes, problem.constraints); });
  Constraints other = problem.constraints;
  other.rhs[0] = 0.1;
  CHECK_THROWS_AS(load(blob, other), base::Error);
}

TEST_CASE("A value that is not finite at any one evaluation does not keep the run from its end") {
  for (const Options& options : every_method) {
    for (const Case& problem : {hock_schittkowski(1.5), hock_schittkowski_53(), random_quadratic(9, 25, 1, 100)}) {
      const std::size_t count = run(problem, options).asked.size();
      for (std::size_t bad = 0; bad < count; ++bad) {
        for (const int kind : {0, 1, 2}) {
          CAPTURE(bad);
          CAPTURE(kind);
          Case spoiled = problem;
          spoiled.function = spoiled_at(problem.function, bad, kind);
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
      double best = infinity;
      Case spoiled = problem;
      spoiled.function = failing_from(problem.function, last, best);
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

TEST_CASE("Sixty-four runs at once on threads end in the bits of one alone") {
  const Case problem = random_quadratic(21, 60, 4, 1e4);
  check_runs_at_once([&] { return run(problem); });
}

TEST_CASE("A host that cancels gets the best point so far") {
  const Case problem = random_quadratic(22, 60, 4, 1e4);
  base::Host host;
  bool stop = false;
  host.on_progress = [&](const base::Progress&) { return !stop; };
  Solver solver(problem.constraints.problem(), {}, problem.start, host);
  std::vector<double> gradient(60);
  check_cancelling(solver, stop, [&](Solver& asking, double more) {
    const double f = problem.function(asking.point(), gradient);
    asking.tell(f + more, gradient);
    return f;
  });
}

TEST_CASE("A value without a request is refused") {
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
