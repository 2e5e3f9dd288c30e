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
        // A cross is requested at once, so that it can do without x0.
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

TEST_CASE("A function without values in half of the space is minimized in the other half") {
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

TEST_CASE("A value without a request is refused") {
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

TEST_CASE("Room is made for what the budget allows, and results do not depend on it") {
  struct Counting : std::pmr::memory_resource {
    std::size_t bytes = 0;
    void* do_allocate(std::size_t size, std::size_t alignment) override {
      bytes += size;
      return std::pmr::new_delete_resource()->allocate(size, alignment);
    }
    void do_deallocate(void* p, std::size_t size, std::size_t alignment) override {
      std::pmr::new_delete_resource()->deallocate(p, size, alignment);
    }
    bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }
  };
  for (const std::size_t n : {1000U, 5000U}) {
    Counting memory;
    base::Host host;
    host.memory = &memory;
    Case c{"distance", std::vector<double>(n, 0.0), 0, {}, 0, {}, {}, {}, {}};
    c.function = [](std::span<const double> x) {
      double sum = 0;
      for (const double value : x)
        sum += (value - 0.3) * (value - 0.3);
      return std::vector<double>{sum};
    };
    Options options;
    options.max_evaluations = 100;
    Solver solver(c.problem(), options, c.start, host);
    const Run end = drive(solver, c.function);
    CHECK(end.result.stop == Stop::evaluation_budget);
    CHECK(end.result.evaluations == 100);
    CHECK(end.result.value < 0.09 * static_cast<double>(n));
    CHECK(memory.bytes < 8 * n * 300);  // some points, nothing square in n
  }
  // A run that is cut short requests the points that a longer one begins with.
  for (const Case& c : every_case()) {
    const Run whole = run(c);
    for (const std::uint64_t budget : {1U, 2U, 3U, 4U, 6U, 9U, 15U, 25U}) {
      Options options;
      options.max_evaluations = budget;
      const Run few = run(c, options);
      REQUIRE(few.asked.size() <= whole.asked.size());
      for (std::size_t k = 0; k < few.asked.size(); ++k)
        CHECK(few.asked[k] == whole.asked[k]);
    }
  }
}

TEST_CASE("Evaluations that are given make room beyond the budget, also in a run that is loaded") {
  const Case c = as_scalar(wood());
  const base::Host host;
  Options options;
  options.max_evaluations = 3;
  Solver solver(c.problem(), options, c.start, host);
  std::vector<std::vector<double>> points = {c.start};
  for (std::size_t k = 0; k < c.start.size(); ++k) {
    points.push_back(c.start);
    points.back()[k] += 0.3;
  }
  for (const auto& x : points)
    solver.give(x, c.function(x));
  std::vector<std::byte> blob(solver.save_size());
  solver.save(blob);
  Solver loaded(c.problem(), Solver::options_of(blob), {}, host);
  loaded.load(blob);
  const Run end = drive(solver, c.function), same = drive(loaded, c.function);
  CHECK(end.result.points > c.start.size());
  CHECK(end.result.evaluations == 3);
  CHECK(end.asked == same.asked);
  CHECK(end.result.value < c.function(c.start)[0]);
}
