// Prints microseconds an evaluation outside of f: processor time of whole runs on the chained Rosenbrock function, less
// that of f alone; best of some repeats. NLopt's L-BFGS keeps as many pairs as its memory of 10 MB holds.
//
// Usage: bench-gradient-overhead [ours: without peers]
#include <orbicube/projected_gradient.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <initializer_list>
#include <limits>

#include "ours.h"
#include "peers.h"

using namespace orbicube::bench;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t evaluation_limit = 300;

// Of this thread, in seconds.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double chained_rosenbrock(std::size_t n, const double* x, double* g) {
  double f = 0;
  g[0] = 0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double bent = x[i + 1] - x[i] * x[i], gone = 1 - x[i];
    f += 100 * bent * bent + gone * gone;
    g[i] += -400 * bent * x[i] - 2 * gone;
    g[i + 1] = 200 * bent;
  }
  return f;
}

Problem make(std::size_t n, double upper) {
  Problem p;
  p.start.assign(n, 0.5);
  for (std::size_t j = 0; j < n; j += 2)
    p.start[j] = -1.2;
  p.lower.assign(n, -infinity);
  p.upper.assign(n, upper);
  p.evaluate = [n](const double* x, double* g) { return chained_rosenbrock(n, x, g); };
  return p;
}

std::size_t run_ours(const Problem& problem) {
  const obc_projected_gradient_problem c = to_c(problem);
  obc_projected_gradient_options options;
  obc_projected_gradient_options_init(&options, sizeof options);
  options.max_evaluations = evaluation_limit;
  obc_projected_gradient_result result{};
  result.struct_size = sizeof result;
  std::vector<double> x = problem.start;
  const obc_projected_gradient_function f = [](const double* at, std::size_t, double* value, double* gradient,
                                               void* user) -> std::int32_t {
    *value = static_cast<const Problem*>(user)->evaluate(at, gradient);
    return OBC_PROJECTED_GRADIENT_CONTINUE;
  };
  obc_projected_gradient_minimize(&c, &options, f, const_cast<Problem*>(&problem), x.data(), &result, nullptr, nullptr);
  return result.evaluations;
}

template <class Run>
void print(const Problem& problem, const char* name, double of_f, const Run& run) {
  double least = infinity;
  std::size_t evaluations = 0;
  for (int repeat = 0; repeat < 7; ++repeat) {
    const std::size_t runs = 1 + 20000 / problem.size() / 100;
    const double start = processor_time();
    evaluations = 0;
    for (std::size_t i = 0; i < runs; ++i)
      evaluations += run();
    least = std::min(least, (processor_time() - start) / static_cast<double>(evaluations));
    evaluations /= runs;
  }
  std::printf(" %s %.2f (%zu evaluations) |", name, 1e6 * (least - of_f), evaluations);
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** arguments) {
  const bool peers = count < 2 || std::strcmp(arguments[1], "ours") != 0;
  for (const double upper : {infinity, 0.8}) {
    for (const std::size_t n : std::initializer_list<std::size_t>{10, 100, 1000}) {
      const Problem problem = make(n, upper);
      std::vector<double> x = problem.start, gradient(n);
      double of_f = infinity;
      for (int repeat = 0; repeat < 7; ++repeat) {
        const double start = processor_time();
        for (int i = 0; i < 1000; ++i)
          x[0] += 1e-9 * problem.evaluate(x.data(), gradient.data());
        of_f = std::min(of_f, (processor_time() - start) / 1000);
        x[0] = problem.start[0];
      }
      std::printf("| %zu, %s |", n, upper == infinity ? "no bounds" : "x <= 0.8");
      print(problem, "default", of_f, [&] { return run_ours(problem); });
      if (peers && has_nlopt())
        print(problem, "NLopt L-BFGS", of_f, [&] { return run_nlopt(problem, evaluation_limit, 1e9)->evaluations; });
      std::printf("\n");
    }
  }
  return 0;
}
