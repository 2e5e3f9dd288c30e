// Checks that hold for the solver of every library that is asked step by step. A Run has the members result, x (the
// best point) and asked (every point at which f was requested).
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <thread>
#include <type_traits>
#include <vector>

#include "base/error.h"

namespace orbicube::test {

inline bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

// For solvers that ask for no products of the Hessian.
struct NoProducts {};

// Fulfils requests for value and gradient, of `size` numbers, and for products of the Hessian at x, by
// multiply(x, direction, product), until the end. Returns the queried points from here on, without those of products;
// gives up where a run would not end.
template <class Run, class Solver, class Function, class Multiply = NoProducts>
Run drive_with_gradient(Solver& solver, std::size_t size, const Function& function, const Multiply& multiply = {}) {
  using Request = decltype(solver.step());
  Run run;
  std::vector<double> gradient(size);
  for (std::uint64_t steps = 0;; ++steps) {
    REQUIRE(steps < 1000000);
    const Request request = solver.step();
    if (request == Request::done) break;
    if (request == Request::iteration) continue;
    if constexpr (!std::is_same_v<Multiply, NoProducts>) {
      if (request == Request::need_product) {
        multiply(solver.point(), solver.direction(), gradient);
        solver.tell_product(gradient);
        continue;
      }
    }
    run.asked.emplace_back(solver.point().begin(), solver.point().end());
    const double value = function(solver.point(), gradient);
    solver.tell(value, gradient);
  }
  run.result = solver.result();
  run.x.assign(solver.best_point().begin(), solver.best_point().end());
  return run;
}

// A function with gradient of which evaluation number `bad`, from 0, is not finite: the value is NaN (kind 0) or
// -infinity (1), or an entry of the gradient is NaN (2).
template <class Function>
Function spoiled_at(const Function& function, std::size_t bad, int kind) {
  return [function, bad, kind, evaluation = std::size_t{0}](std::span<const double> x, std::span<double> g) mutable {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const double f = function(x, g);
    if (evaluation++ != bad) return f;
    if (kind == 2) g[g.size() - 1] = nan;
    return kind == 0 ? nan : kind == 1 ? -std::numeric_limits<double>::infinity() : f;
  };
}

// A function that has no value from evaluation number `last` on; `best` becomes the minimum of those before.
template <class Function>
Function failing_from(const Function& function, std::size_t last, double& best) {
  best = std::numeric_limits<double>::infinity();
  return [function, last, &best, evaluation = std::size_t{0}](std::span<const double> x, std::span<double> g) mutable {
    if (evaluation++ >= last) return std::numeric_limits<double>::quiet_NaN();
    const double f = function(x, g);
    best = std::min(best, f);
    return f;
  };
}

// Saves `solver`, which is at its beginning, while each request waits and after it was fulfilled, and lets
// finish(blob), which loads the blob and returns the Run from there to its end, go on: it must be the rest of `whole`.
template <class Solver, class Run, class Answer, class Finish>
void check_resuming(Solver& solver, const Run& whole, const Answer& answer, const Finish& finish) {
  std::vector<std::byte> blob;
  std::size_t evaluation = 0;
  bool same = true;
  using Request = decltype(solver.step());
  for (Request request; (request = solver.step()) != Request::done;) {
    if (request == Request::iteration) continue;
    for (const bool told : {false, true}) {
      if (told) answer(solver);
      blob.resize(solver.save_size());
      solver.save(blob);
      const Run rest = finish(std::span<const std::byte>(blob));
      const std::size_t first = evaluation + (told ? 1 : 0);
      REQUIRE(rest.asked.size() == whole.asked.size() - first);
      for (std::size_t k = 0; k < rest.asked.size(); ++k)
        same = same && same_bits(rest.asked[k], whole.asked[first + k]);
      same = same && same_bits(rest.x, whole.x);
      same = same && rest.result.evaluations == whole.result.evaluations && rest.result.stop == whole.result.stop;
    }
    ++evaluation;
  }
  CHECK(same);
  CHECK(evaluation == whole.asked.size());
}

// load(bytes) must refuse what is not quite `blob`.
template <class Load>
void check_damaged_blobs(const std::vector<std::byte>& blob, const Load& load) {
  CHECK_NOTHROW(load(blob));
  for (std::size_t i = 0; i < blob.size(); i += 5) {
    std::vector<std::byte> damaged = blob;
    damaged[i] ^= std::byte{0x10};
    CHECK_THROWS_AS(load(damaged), base::Error);
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{10}, std::size_t{100}, blob.size() - 1}) {
    const auto end = blob.begin() + static_cast<std::ptrdiff_t>(size);
    CHECK_THROWS_AS(load(std::vector<std::byte>(blob.begin(), end)), base::Error);
  }
}

// Sixty-four runs at once end like one alone.
template <class MakeRun>
void check_runs_at_once(const MakeRun& make_run) {
  const auto alone = make_run();
  std::vector<decltype(make_run())> runs(64);
  {
    std::vector<std::jthread> threads;
    for (auto& slot : runs)
      threads.emplace_back([&] { slot = make_run(); });
  }
  for (const auto& other : runs) {
    CHECK(same_bits(other.x, alone.x));
    CHECK(other.result.evaluations == alone.result.evaluations);
  }
}

// Ten evaluations by answer(solver, more), which supplies the value plus `more` and returns the value; then `stop` is
// set, by which the host of the solver cancels.
template <class Solver, class Answer>
void check_cancelling(Solver& solver, bool& stop, const Answer& answer) {
  using Request = decltype(solver.step());
  const auto asks = [&] {
    const Request request = solver.step();
    return request != Request::done && request != Request::iteration;
  };
  double best = std::numeric_limits<double>::infinity();
  for (int evaluation = 0; evaluation < 10;) {
    if (!asks()) continue;
    ++evaluation;
    best = std::min(best, answer(solver, 0.0));
  }
  stop = true;
  // Reports are passed on every at most 20 ms.
  for (int step = 0; step < 1000 && solver.step() != Request::done; ++step) {
    if (asks()) answer(solver, 1e6);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  CHECK(solver.result().stop == decltype(solver.result().stop)::cancelled);
  CHECK(solver.cancelled_by_host());
  CHECK(solver.result().value == best);
  CHECK(solver.step() == Request::done);
}

}  // namespace orbicube::test
