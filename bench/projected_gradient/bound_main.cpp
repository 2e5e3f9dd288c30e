// Runs this library and NLopt's L-BFGS on the problems with bounds only, until the projected gradient is within the
// problem's tolerance or f within 1e-6 (relative) of the known minimum; a line a run, for bound_problems.py, which adds
// SciPy's L-BFGS-B and makes the table.
//
// Usage: bench-bound-problems [ours|nlopt|all] [part of a name] [evaluation limit] [memory pairs]
#include <orbicube/projected_gradient.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "bound_problems.h"
#include "ours.h"
#include "peers.h"

using namespace orbicube::bench;

namespace {

using Clock = std::chrono::steady_clock;

// Counts evaluations until the problem is solved.
struct Counter {
  const BoundProblem& problem;
  std::size_t limit, count = 0;
  bool solved = false;
  double value = 0, measure = 0;

  // Evaluates f; true when the run can end.
  bool evaluate(const double* x, double* f, double* gradient) {
    *f = value = problem.evaluate(x, gradient);
    ++count;
    measure = 0;
    for (std::size_t j = 0; j < problem.size(); ++j) {
      const double moved = std::clamp(x[j] - gradient[j], problem.lower[j], problem.upper[j]);
      measure = std::max(measure, std::abs(moved - x[j]));
    }
    solved = measure <= problem.tolerance ||
             (problem.optimum != 0 && value <= problem.optimum + 1e-6 * std::abs(problem.optimum));
    return solved || count >= limit;
  }
};

void print(const char* solver, const Counter& counter, double seconds) {
  std::printf("%s\t%zu\t%s\t%d\t%zu\t%.4f\t%.12g\t%.1e\n", counter.problem.name.c_str(), counter.problem.size(), solver,
              counter.solved ? 1 : 0, counter.count, seconds, counter.value, counter.measure);
  std::fflush(stdout);
}

void run_ours(const BoundProblem& problem, std::size_t limit, std::uint32_t memory) {
  const obc_projected_gradient_problem c = to_c(problem);
  obc_projected_gradient_options options;
  obc_projected_gradient_options_init(&options, sizeof options);
  options.max_evaluations = limit;
  options.gradient_tolerance = 0;
  if (memory > 0) options.memory = memory;
  Counter counter{problem, limit};
  const obc_projected_gradient_function f = [](const double* x, std::size_t, double* value, double* gradient,
                                               void* user) -> std::int32_t {
    const bool end = static_cast<Counter*>(user)->evaluate(x, value, gradient);
    return end ? OBC_PROJECTED_GRADIENT_STOP : OBC_PROJECTED_GRADIENT_CONTINUE;
  };
  std::vector<double> x = problem.start;
  const auto start = Clock::now();
  obc_error error;
  if (obc_projected_gradient_minimize(&c, &options, f, &counter, x.data(), nullptr, nullptr, &error) != OBC_OK) {
    std::fprintf(stderr, "%s: %s\n", error.kind, error.message);
    std::exit(1);
  }
  print("ours", counter, std::chrono::duration<double>(Clock::now() - start).count());
}

// NLopt takes value and gradient in one call; the problem solved looks to it like a value that ends the run.
void run_nlopt_until_solved(const BoundProblem& problem, std::size_t limit) {
  Counter counter{problem, limit};
  Problem stopping = problem;
  bool ended = false;
  stopping.evaluate = [&](const double* x, double* gradient) {
    double f = 0;
    if (ended) {
      std::fill(gradient, gradient + problem.size(), 0.0);
      return counter.value;
    }
    ended = counter.evaluate(x, &f, gradient);
    return f;
  };
  for (std::size_t j = 0; j < stopping.size(); ++j)
    stopping.start[j] = std::clamp(stopping.start[j], stopping.lower[j], stopping.upper[j]);
  const auto start = Clock::now();
  if (!run_nlopt(stopping, limit, 20)) return;
  print("NLopt", counter, std::chrono::duration<double>(Clock::now() - start).count());
}

}  // namespace

int main(int count, char** arguments) {
  const char* solvers = count > 1 ? arguments[1] : "all";
  const char* part = count > 2 ? arguments[2] : "";
  const std::size_t limit = count > 3 ? std::strtoull(arguments[3], nullptr, 10) : 50000;
  const auto memory = static_cast<std::uint32_t>(count > 4 ? std::strtoul(arguments[4], nullptr, 10) : 0);
  for (std::size_t index = 0; index < bound_problem_count(); ++index) {
    const BoundProblem problem = make_bound_problem(index);
    if (std::strstr(problem.name.c_str(), part) == nullptr) continue;
    if (std::strcmp(solvers, "nlopt") != 0) run_ours(problem, limit, memory);
    if (std::strcmp(solvers, "ours") != 0) run_nlopt_until_solved(problem, limit);
  }
  return 0;
}
