// Prints a table: evaluations (value and gradient together), projected gradient reached and seconds of each method on
// each problem; then the projection of a million unknowns onto a box and one row. Everything runs in this process
// through the C interface; compare.py adds SciPy's L-BFGS-B on the same problems.
//
// Usage: bench-projected-gradient [seconds that a run may take, default 60] [ours: without peers]
#include <orbicube/projected_gradient.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>

#include "ours.h"
#include "peers.h"

using namespace orbicube::bench;

namespace {

constexpr std::size_t evaluation_limit = 40000;

struct Timed {
  const Problem& problem;
  std::chrono::steady_clock::time_point end;
};

Outcome run_ours(const Problem& problem, std::int32_t method, std::int32_t line_search, double seconds_limit) {
  const obc_projected_gradient_problem c = to_c(problem);
  obc_projected_gradient_options options;
  obc_projected_gradient_options_init(&options, sizeof options);
  options.method = method;
  options.line_search = line_search;
  options.max_evaluations = evaluation_limit;
  obc_projected_gradient_result result{};
  result.struct_size = sizeof result;
  Outcome outcome;
  outcome.x = problem.start;
  const auto start = std::chrono::steady_clock::now();
  Timed timed{problem, start + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                   std::chrono::duration<double>(seconds_limit))};
  const obc_projected_gradient_function f = [](const double* x, std::size_t, double* value, double* gradient,
                                               void* user) -> std::int32_t {
    const Timed& run = *static_cast<const Timed*>(user);
    if (std::chrono::steady_clock::now() > run.end) return OBC_PROJECTED_GRADIENT_STOP;
    *value = run.problem.evaluate(x, gradient);
    return OBC_PROJECTED_GRADIENT_CONTINUE;
  };
  obc_error error;
  if (obc_projected_gradient_minimize(&c, &options, f, &timed, outcome.x.data(), &result, nullptr, &error) != OBC_OK) {
    std::fprintf(stderr, "%s: %s\n", error.kind, error.message);
    std::exit(1);
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.evaluations = result.evaluations;
  return outcome;
}

// |P(x - g) - x|inf, the same measure for every solver.
double projected_gradient(const Problem& problem, const std::vector<double>& x) {
  std::vector<double> gradient(x.size()), moved(x.size()), projected(x.size());
  problem.evaluate(x.data(), gradient.data());
  for (std::size_t j = 0; j < x.size(); ++j)
    moved[j] = x[j] - gradient[j];
  for (const double value : moved) {
    if (!std::isfinite(value)) return std::numeric_limits<double>::infinity();
  }
  const obc_projected_gradient_problem c = to_c(problem);
  obc_projected_gradient_project(&c, moved.data(), projected.data(), nullptr, nullptr, nullptr, nullptr);
  double worst = 0;
  for (std::size_t j = 0; j < x.size(); ++j)
    worst = std::max(worst, std::abs(projected[j] - x[j]));
  return worst;
}

double equality_residual(const Problem& problem, const std::vector<double>& x) {
  double worst = 0;
  for (std::size_t i = 0; i < problem.rows(); ++i) {
    long double sum = -problem.rhs[i], scale = std::abs(problem.rhs[i]);
    for (std::size_t k = problem.row_start[i]; k < problem.row_start[i + 1]; ++k) {
      const long double term = static_cast<long double>(problem.value[k]) * x[problem.column[k]];
      sum += term;
      scale += std::abs(term);
    }
    if (sum != 0) worst = std::max(worst, static_cast<double>(std::abs(sum) / scale));
  }
  return worst;
}

void print(const Problem& problem, const char* solver, const std::optional<Outcome>& outcome) {
  if (!outcome) {
    std::printf("| %s | %s | - | | | | |\n", problem.name.c_str(), solver);
    return;
  }
  std::vector<double> gradient(problem.size());
  const double f = problem.evaluate(outcome->x.data(), gradient.data());
  std::printf("| %s | %s | %zu | %.1e | %.12g | %.0e | %.2f |\n", problem.name.c_str(), solver, outcome->evaluations,
              projected_gradient(problem, outcome->x), f, equality_residual(problem, outcome->x), outcome->seconds);
  std::fflush(stdout);
}

void project_a_million(const char* name, double spread_of_a, double spread_of_bounds, double distance) {
  constexpr std::size_t n = 1000000;
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  Problem problem;
  problem.lower.assign(n, 0.0);
  problem.upper.resize(n);
  problem.start.resize(n);
  problem.rhs.assign(1, 0.0);
  for (std::size_t j = 0; j < n; ++j) {
    problem.start[j] = distance * normal(random);
    problem.upper[j] = std::pow(10.0, spread_of_bounds * uniform(random));
    problem.column.push_back(static_cast<std::uint32_t>(j));
    problem.value.push_back((random() % 2 ? 1 : -1) * std::pow(10.0, spread_of_a * uniform(random)));
    problem.rhs[0] += problem.value[j] * problem.upper[j] * uniform(random);
  }
  problem.row_start.push_back(n);
  const obc_projected_gradient_problem c = to_c(problem);
  std::vector<double> x(n);
  double t = 0;
  obc_projected_gradient_result result{};
  result.struct_size = sizeof result;
  const auto start = std::chrono::steady_clock::now();
  obc_projected_gradient_project(&c, problem.start.data(), x.data(), &t, &result, nullptr, nullptr);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  double worst = 0;
  for (std::size_t j = 0; j < n; ++j) {
    const double moved = problem.start[j] + t * problem.value[j];
    const double wanted = std::clamp(moved, problem.lower[j], problem.upper[j]);
    worst =
        std::max(worst, std::abs(x[j] - wanted) / (1 + std::abs(problem.start[j]) + std::abs(t * problem.value[j])));
  }
  std::printf("| %s | %llu | %.1e | %.1e | %.3f |\n", name, static_cast<unsigned long long>(result.projection_passes),
              worst, equality_residual(problem, x), seconds);
}

}  // namespace

int main(int count, char** arguments) {
  const double seconds = count > 1 ? std::atof(arguments[1]) : 60;
  const bool peers = count < 3 || std::strcmp(arguments[2], "ours") != 0;
  std::printf("Peers: NLopt %s, IPOPT %s.\n\n", has_nlopt() ? "yes" : "not found", has_ipopt() ? "yes" : "not found");
  std::printf("| problem | solver | evaluations | projected gradient | f | residual of A x = b | seconds |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  for (std::size_t index = 0; index < problem_count(); ++index) {
    const Problem problem = make_problem(index);
    print(problem, "default", run_ours(problem, OBC_PROJECTED_GRADIENT_FACE, 0, seconds));
    print(problem, "seed, largest of last", run_ours(problem, OBC_PROJECTED_GRADIENT_DISSERTATION, 0, seconds));
    print(problem, "seed, average", run_ours(problem, OBC_PROJECTED_GRADIENT_DISSERTATION, 1, seconds));
    if (!peers) continue;
    print(problem, problem.rows() > 0 ? "NLopt SLSQP" : "NLopt L-BFGS", run_nlopt(problem, evaluation_limit, seconds));
    print(problem, "IPOPT L-BFGS", run_ipopt(problem, evaluation_limit, seconds));
  }
  std::printf(
      "\n| projection of 1e6 unknowns onto a box and one row | passes | |x - clip(y + t a)| | residual | seconds |\n");
  std::printf("|---|---|---|---|---|\n");
  project_a_million("all of one size", 0, 0, 1);
  project_a_million("a over 6 decades, bounds over 4", 6, 4, 1);
  project_a_million("a over 2 decades, points 1e6 times farther than the box", 2, 0, 1e6);
  return 0;
}
