// What may go wrong or be cut short: saving at any evaluation, values that are not finite, budgets, threads,
// cancelling.
#include <doctest/doctest.h>

#include <chrono>
#include <thread>

#include "base/error.h"
#include "runs.h"

using namespace orbicube;
using namespace orbicube::test;

TEST_CASE("Saved at each evaluation and loaded into a new solver, a run goes on with the same bits") {
  for (const Case& c : every_case()) {
    const Run whole = run(c);
    const base::Host host;
    Solver solver(c.problem(), {}, c.start, host);
    std::size_t evaluation = 0;
    std::vector<std::byte> blob;
    for (Request request; (request = solver.step()) != Request::done;) {
      if (request != Request::need_values) continue;
      for (const bool told : {false, true}) {  // while a request waits, and after it was answered
        if (told) solver.tell(c.function(solver.pending().first(solver.size())));
        blob.resize(solver.save_size());
        solver.save(blob);
        Solver loaded(c.problem(), Solver::options_of(blob), {}, host);
        loaded.load(blob);
        std::vector<std::vector<double>> asked;
        drive(loaded, c.function, &asked);
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
      ++evaluation;
    }
  }
}

TEST_CASE("A damaged or foreign blob is refused") {
  const Case c = rosenbrock();
  const base::Host host;
  Solver solver(c.problem(), {}, c.start, host);
  std::vector<std::byte> blob(solver.save_size());
  solver.save(blob);
  const auto refuses = [&](const std::vector<std::byte>& bytes, const Case& of) {
    const auto load = [&] {
      Solver loaded(of.problem(), Solver::options_of(bytes), {}, host);
      loaded.load(bytes);
    };
    CHECK_THROWS_AS(load(), base::Error);
  };
  for (std::size_t i = 0; i < blob.size(); i += 7) {
    std::vector<std::byte> damaged = blob;
    damaged[i] ^= std::byte{0x10};
    refuses(damaged, c);
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{10}, blob.size() - 1})
    refuses({blob.begin(), blob.begin() + static_cast<std::ptrdiff_t>(size)}, c);
  Case other = c;
  other.lower = {-5, -5};
  refuses(blob, other);
  refuses(blob, as_scalar(c));
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
  for (const Case& c : {wood(), as_scalar(wood())}) {
    const Run alone = run(c);
    std::vector<Run> runs(64);
    {
      std::vector<std::jthread> threads;
      for (Run& slot : runs)
        threads.emplace_back([&] { slot = run(c); });
    }
    for (const Run& other : runs) {
      CHECK(same_bits(other.x, alone.x));
      CHECK(other.result.evaluations == alone.result.evaluations);
    }
  }
}

TEST_CASE("A host that cancels gets the best point so far") {
  const Case c = as_scalar(wood());
  base::Host host;
  bool stop = false;
  host.on_progress = [&](const base::Progress&) { return !stop; };
  Solver solver(c.problem(), {}, c.start, host);
  double best = infinity;
  for (int evaluation = 0; evaluation < 10;) {
    if (solver.step() != Request::need_values) continue;
    ++evaluation;
    const std::vector<double> f = c.function(solver.pending());
    best = std::min(best, f[0]);
    solver.tell(f);
  }
  stop = true;
  // Reports are passed on every 20 ms at most.
  for (int step = 0; step < 1000 && solver.step() != Request::done; ++step) {
    if (solver.step() == Request::need_values) solver.tell(std::vector<double>{best + 1});
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  CHECK(solver.result().stop == Stop::cancelled);
  CHECK(solver.cancelled_by_host());
  CHECK(solver.result().value == best);
  CHECK(solver.step() == Request::done);
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
