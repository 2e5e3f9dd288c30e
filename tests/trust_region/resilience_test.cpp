// What may go wrong or be cut short: saving at any evaluation, values that are not finite, budgets, threads,
// cancelling.
#include <doctest/doctest.h>

#include "base/error.h"
#include "runs.h"

using namespace orbicube;
using namespace orbicube::test;

TEST_CASE("Saved at each evaluation and loaded into a new solver, a run goes on with the same bits") {
  for (const Case& c : every_case()) {
    const base::Host host;
    Solver solver(c.problem(), {}, c.start, host);
    check_resuming(
        solver, run(c), [&](Solver& asking) { asking.tell(c.function(asking.pending().first(asking.size()))); },
        [&](std::span<const std::byte> blob) {
          Solver loaded(c.problem(), Solver::options_of(blob), {}, host);
          loaded.load(blob);
          return drive(loaded, c.function);
        });
  }
}

TEST_CASE("A damaged or foreign blob is refused") {
  const Case c = rosenbrock();
  const base::Host host;
  Solver solver(c.problem(), {}, c.start, host);
  std::vector<std::byte> blob(solver.save_size());
  solver.save(blob);
  const auto load = [&](const std::vector<std::byte>& bytes, const Case& of) {
    Solver loaded(of.problem(), Solver::options_of(bytes), {}, host);
    loaded.load(bytes);
  };
  check_damaged_blobs(blob, [&](const auto& bytes) { load(bytes, c); });
  Case other = c;
  other.lower = {-5, -5};
  CHECK_THROWS_AS(load(blob, other), base::Error);
  CHECK_THROWS_AS(load(blob, as_scalar(c)), base::Error);
}

TEST_CASE("A value that is not finite at any one evaluation does not keep the run from its end") {
  for (const Case& c : every_case()) {
    const std::size_t count = run(c).asked.size();
    for (std::size_t bad = 0; bad < count; ++bad) {
      for (const double value : {std::nan(""), infinity, -infinity}) {
        CAPTURE(std::string(c.name));
        CAPTURE(bad);
        std::size_t evaluation = 0;
        Case spoiled = c;
        spoiled.function = [&](std::span<const double> x) {
          std::vector<double> outputs = c.function(x);
          if (evaluation++ == bad) outputs.back() = value;
          return outputs;
        };
        const Run end = run(spoiled);
        CHECK(end.result.failed_evaluations <= 1);
        // A cross is asked for at once, so that it can do without x0.
        if (bad == 0 && (c.residuals > 0 || c.lower.empty())) {
          CHECK(end.result.stop == Stop::evaluation_failed);
          CHECK(std::isnan(end.result.value));
        } else {
          CHECK(end.result.stop == Stop::converged);
          CHECK(end.result.value <= c.minimum + 1e-8);
        }
        bool inside = true;
        for (const auto& x : end.asked)
          inside = inside && within_bounds(c, x);
        CHECK(inside);
      }
    }
  }
}

TEST_CASE("A function without values in half of the space is minimised in the other half") {
  for (Case c : {rosenbrock(), as_scalar(rosenbrock())}) {
    c.function = [inner = c.function](std::span<const double> x) {
      std::vector<double> outputs = inner(x);
      if (x[0] > -1.1 + 0.1 * x[1]) outputs[0] = std::nan("");
      return outputs;
    };
    const Run end = run(c);
    CHECK(end.result.stop != Stop::running);
    CHECK(std::isfinite(end.result.value));
    CHECK(end.result.value < 5);
  }
}

TEST_CASE("When f fails from some evaluation on, the run ends with its best point") {
  for (const Case& c : {rosenbrock(), as_scalar(wood())}) {
    for (std::size_t last = 1; last < 20; ++last) {
      std::size_t evaluation = 0;
      double best = infinity;
      Case spoiled = c;
      spoiled.function = [&](std::span<const double> x) {
        std::vector<double> outputs = c.function(x);
        if (evaluation++ >= last) {
          outputs[0] = std::nan("");
        } else {
          best = std::min(best, c.residuals > 0 ? sum_of_squares(outputs) : outputs[0]);
        }
        return outputs;
      };
      const Run end = run(spoiled);
      CHECK((end.result.stop == Stop::evaluation_failed || end.result.stop == Stop::converged));
      CHECK(end.result.value == best);
      CHECK(end.result.evaluations < last + 200);
    }
  }
}

TEST_CASE("Budgets and targets end a run, and the best point is known at any time") {
  for (const Case& c : {wood(), as_scalar(wood())}) {
    for (std::uint64_t budget = 1; budget < 30; ++budget) {
      Options options;
      options.max_evaluations = budget;
      options.start = budget % 2 == 0 ? Start::cross : Start::chain;
      const Run few = run(c, options);
      CHECK(few.result.stop == Stop::evaluation_budget);
      CHECK(few.result.evaluations == budget);
      double best = infinity;
      for (const auto& x : few.asked) {
        const std::vector<double> outputs = c.function(x);
        best = std::min(best, c.residuals > 0 ? sum_of_squares(outputs) : outputs[0]);
      }
      CHECK(few.result.value == best);
    }
    Options options;
    options.target = 1.0;
    const Run target = run(c, options);
    CHECK(target.result.stop == Stop::target_reached);
    CHECK(target.result.value <= 1.0);
  }
}

TEST_CASE("A constant function, huge values and a tolerance below rounding all come to an end") {
  Case c = as_scalar(rosenbrock());
  c.function = [](std::span<const double>) { return std::vector<double>{3.0}; };
  CHECK(run(c).result.stop == Stop::converged);
  const Function inner = as_scalar(wood()).function;
  c = as_scalar(wood());
  c.function = [&](std::span<const double> x) { return std::vector<double>{1e200 * inner(x)[0]}; };
  CHECK(run(c).result.stop != Stop::running);
  c.function = [&](std::span<const double> x) { return std::vector<double>{1e-200 * inner(x)[0]}; };
  CHECK(run(c).result.stop != Stop::running);
  c.function = inner;
  Options options;
  options.radius_end = 1e-30;
  options.max_evaluations = 3000;
  const Run end = run(c, options);
  CHECK(end.result.stop != Stop::running);
  CHECK(end.result.value < 1e-12);
}

TEST_CASE("Sixty-four runs at once on threads end in the bits of one alone") {
  for (const Case& c : {wood(), as_scalar(wood())})
    check_runs_at_once([&] { return run(c); });
}

TEST_CASE("A host that cancels gets the best point so far") {
  const Case c = as_scalar(wood());
  base::Host host;
  bool stop = false;
  host.on_progress = [&](const base::Progress&) { return !stop; };
  Solver solver(c.problem(), {}, c.start, host);
  check_cancelling(solver, stop, [&](Solver& asking, double more) {
    const double f = c.function(asking.pending())[0];
    asking.tell(std::vector<double>{f + more});
    return f;
  });
}

TEST_CASE("What is not asked for cannot be told") {
  const Case c = rosenbrock();
  const base::Host host;
  Solver solver(c.problem(), {}, c.start, host);
  const std::vector<double> outputs(2, 1.0);
  CHECK_THROWS_AS(solver.tell(outputs), base::Error);
  CHECK(solver.step() == Request::need_values);
  CHECK(solver.step() == Request::need_values);
  CHECK_THROWS_AS(solver.tell(std::vector<double>(3)), base::Error);
  solver.tell(outputs);
  CHECK_THROWS_AS(solver.tell(outputs), base::Error);
}
