// What may go wrong or be cut short: saving at any evaluation, values that are not finite, budgets, rounding, threads,
// cancelling.
#include <doctest/doctest.h>

#include "base/error.h"
#include "problems.h"

using namespace orbicube;
using namespace orbicube::test;

TEST_CASE("Saved at each evaluation and loaded into a new solver, a run goes on with the same bits") {
  for (const Method method : every_method) {
    for (const Problem& problem : {thomson(7, 1), laplacian(12, 1), maximum_cut(3, 4, 1)}) {
      Options options = with(method, 1e-5);
      options.memory = 5;
      options.max_evaluations = 60;
      check_resuming_of(problem, options);
    }
  }
}

TEST_CASE("A damaged or foreign blob is refused") {
  const Problem problem = thomson(3, 1);
  const base::Host host;
  Solver solver(problem.shape, {}, problem.start, host);
  std::vector<std::byte> blob(solver.save_size());
  solver.save(blob);
  const auto load = [&](const std::vector<std::byte>& bytes, const Shape& shape, const Options& options) {
    Solver loaded(shape, options, {}, host);
    loaded.load(bytes);
  };
  check_damaged_blobs(blob, [&](const auto& bytes) { load(bytes, problem.shape, {}); });
  check_damaged_blobs(blob, [&](const auto& bytes) { Solver::shape_of(bytes); });
  CHECK_THROWS_AS(load(blob, {4, 3}, {}), base::Error);
  CHECK_THROWS_AS(load(blob, {3, 3}, with(Method::barzilai_borwein)), base::Error);
}

TEST_CASE("A value that is not finite at any one evaluation does not keep the run from its end") {
  for (const Method method : every_method) {
    const Problem problem = thomson(6, 2);
    Options options = with(method, 1e-5);
    options.max_evaluations = 3000;
    const std::size_t count = run(problem, options).asked.size();
    for (std::size_t bad = 0; bad < count; ++bad) {
      for (const int kind : {0, 1, 2}) {
        CAPTURE(bad);
        CAPTURE(kind);
        Problem spoiled = problem;
        spoiled.function = spoiled_at(problem.function, bad, kind);
        const Run end = run(spoiled, options);
        CHECK(end.result.failed_evaluations == 1);
        if (bad == 0) {
          CHECK(end.result.stop == Stop::evaluation_failed);
          CHECK(std::isnan(end.result.value));
        } else if (method != Method::dissertation) {  // which ends at saddles, too
          CHECK(end.result.stop == Stop::converged);
          CHECK(stationarity(problem, end.x) <= 1.01e-5);
        }
        CHECK(length_error(problem.shape, end.x) <= 2);
      }
    }
  }
}

TEST_CASE("When f fails from some evaluation on, the run ends with its best point") {
  const Problem problem = thomson(9, 3);
  for (const Method method : every_method) {
    for (std::size_t last = 1; last < 20; ++last) {
      double best = infinity;
      Problem spoiled = problem;
      spoiled.function = failing_from(problem.function, last, best);
      const Run end = run(spoiled, with(method));
      CHECK(end.result.stop == Stop::evaluation_failed);
      CHECK(end.result.value == best);
      std::vector<double> gradient(end.x.size());
      CHECK(problem.function(end.x, gradient) == best);
      CHECK(end.result.evaluations < 200);
    }
  }
}

TEST_CASE("Budgets and targets end a run, and the best point is known at any time") {
  const Problem problem = thomson(20, 4);
  for (const Method method : every_method) {
    Options options = with(method);
    options.max_evaluations = 7;
    const Run few = run(problem, options);
    CHECK(few.result.stop == Stop::evaluation_budget);
    CHECK(few.result.evaluations == 7);
    double best = infinity;
    std::vector<double> gradient(60);
    for (const auto& x : few.asked)
      best = std::min(best, problem.function(x, gradient));
    CHECK(few.result.value == best);
    options.max_evaluations = 10000;
    options.max_iterations = 5;
    CHECK(run(problem, options).result.stop == Stop::iteration_budget);
    options.max_iterations = 10000;
    options.target = 152;  // the least is 150.88
    const Run target = run(problem, options);
    CHECK(target.result.stop == Stop::target_reached);
    CHECK(target.result.value <= 152);
  }
}

TEST_CASE("A tolerance below what rounding allows ends as stalled, close to the solution") {
  Problem problem = thomson(12, 5);
  problem.function = [inner = problem.function](std::span<const double> x, std::span<double> g) {
    return inner(x, g) + 1e5;  // hides differences below 1e-11
  };
  for (const Method method : every_method) {
    const Run end = run(problem, with(method, 0));
    CHECK((end.result.stop == Stop::stalled || end.result.stop == Stop::converged));
    // Values resolve 1e-11, so slopes of its root; the default goes on by slopes alone.
    CHECK(stationarity(problem, end.x) < (method == Method::limited_memory ? 1e-7 : 1e-3));
  }
}

TEST_CASE("A start that is stationary already ends at once, and one with a gradient of zero") {
  const Problem problem{{1, 3}, {0, 0, 2}, [](std::span<const double>, std::span<double> g) {
                          std::fill(g.begin(), g.end(), 0.0);
                          g[2] = 5;
                          return 5.0;
                        }};
  for (const Method method : every_method) {
    const Run end = run(problem, with(method, 0));
    CHECK(end.result.stop == Stop::converged);
    CHECK(end.result.evaluations == 1);
    CHECK(end.x == std::vector<double>{0, 0, 1});
  }
}

TEST_CASE("Sixty-four runs at once on threads end in the bits of one alone") {
  const Problem problem = thomson(24, 6);
  check_runs_at_once([&] { return run(problem); });
}

TEST_CASE("A host that cancels gets the best point so far") {
  const Problem problem = thomson(30, 7);
  base::Host host;
  bool stop = false;
  host.on_progress = [&](const base::Progress&) { return !stop; };
  Solver solver(problem.shape, {}, problem.start, host);
  std::vector<double> gradient(90);
  check_cancelling(solver, stop, [&](Solver& asking, double more) {
    const double f = problem.function(asking.point(), gradient);
    asking.tell(f + more, gradient);
    return f;
  });
}

TEST_CASE("A value without a request is refused") {
  const Problem problem = thomson(3, 1);
  const base::Host host;
  Solver solver(problem.shape, {}, problem.start, host);
  const std::vector<double> gradient(9);
  CHECK_THROWS_AS(solver.tell(1, gradient), base::Error);
  CHECK(solver.step() == Request::need_value_and_gradient);
  CHECK(solver.step() == Request::need_value_and_gradient);
  CHECK_THROWS_AS(solver.tell(1, std::vector<double>(3)), base::Error);
  solver.tell(1, gradient);
  CHECK_THROWS_AS(solver.tell(1, gradient), base::Error);
}
