#include "peers.h"

#include <algorithm>
#include <chrono>

#ifdef ORBICUBE_BENCH_NLOPT
#include <nlopt.h>
#endif
#ifdef ORBICUBE_BENCH_IPOPT
#include <coin/IpStdCInterface.h>
#endif

namespace orbicube::bench {
namespace {

[[maybe_unused]] double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// A problem with a count of its evaluations; value and gradient of one point are evaluated once together.
struct Counted {
  const Problem& problem;
  std::size_t count = 0;
  std::vector<double> at, gradient;
  double value = 0;

  explicit Counted(const Problem& p) : problem(p), gradient(p.size()) {}
  void evaluate(const double* x) {
    if (std::equal(at.begin(), at.end(), x) && !at.empty()) return;
    at.assign(x, x + problem.size());
    value = problem.evaluate(x, gradient.data());
    ++count;
  }
};

}  // namespace

#ifdef ORBICUBE_BENCH_NLOPT

bool has_nlopt() {
  return true;
}

std::optional<Outcome> run_nlopt(const Problem& problem, std::size_t evaluation_limit, double seconds_limit) {
  if (problem.rows() > 0 && problem.size() > 200) return std::nullopt;  // SLSQP is dense
  const auto start = std::chrono::steady_clock::now();
  Counted counted(problem);
  const nlopt_opt solver =
      nlopt_create(problem.rows() > 0 ? NLOPT_LD_SLSQP : NLOPT_LD_LBFGS, static_cast<unsigned>(problem.size()));
  nlopt_set_lower_bounds(solver, problem.lower.data());
  nlopt_set_upper_bounds(solver, problem.upper.data());
  nlopt_set_maxeval(solver, static_cast<int>(evaluation_limit));
  nlopt_set_maxtime(solver, seconds_limit);
  nlopt_set_min_objective(
      solver,
      [](unsigned n, const double* x, double* gradient, void* user) {
        Counted& c = *static_cast<Counted*>(user);
        c.evaluate(x);
        if (gradient != nullptr) std::copy_n(c.gradient.begin(), n, gradient);
        return c.value;
      },
      &counted);
  struct Row {
    const Problem* problem;
    std::size_t index;
  };
  std::vector<Row> rows;
  for (std::size_t i = 0; i < problem.rows(); ++i)
    rows.push_back({&problem, i});
  for (Row& row : rows) {
    nlopt_add_equality_constraint(
        solver,
        [](unsigned n, const double* x, double* gradient, void* user) {
          const Row& r = *static_cast<Row*>(user);
          if (gradient != nullptr) std::fill_n(gradient, n, 0.0);
          double sum = -r.problem->rhs[r.index];
          for (std::size_t k = r.problem->row_start[r.index]; k < r.problem->row_start[r.index + 1]; ++k) {
            sum += r.problem->value[k] * x[r.problem->column[k]];
            if (gradient != nullptr) gradient[r.problem->column[k]] += r.problem->value[k];
          }
          return sum;
        },
        &row, 1e-14);
  }
  Outcome outcome;
  outcome.x = problem.start;
  for (std::size_t j = 0; j < outcome.x.size(); ++j) {
    outcome.x[j] = std::clamp(outcome.x[j], problem.lower[j], problem.upper[j]);
  }
  double value = 0;
  nlopt_optimize(solver, outcome.x.data(), &value);
  nlopt_destroy(solver);
  outcome.evaluations = counted.count;
  outcome.seconds = seconds_since(start);
  return outcome;
}

#else

bool has_nlopt() {
  return false;
}

std::optional<Outcome> run_nlopt(const Problem&, std::size_t, double) {
  return std::nullopt;
}

#endif

#ifdef ORBICUBE_BENCH_IPOPT

bool has_ipopt() {
  return true;
}

std::optional<Outcome> run_ipopt(const Problem& problem, std::size_t evaluation_limit, double seconds_limit) {
  const auto start = std::chrono::steady_clock::now();
  Counted counted(problem);
  const Index n = static_cast<Index>(problem.size()), m = static_cast<Index>(problem.rows());
  std::vector<double> lower = problem.lower, upper = problem.upper, rhs = problem.rhs;
  for (double& bound : lower)
    bound = std::max(bound, -2e19);
  for (double& bound : upper)
    bound = std::min(bound, 2e19);
  const Eval_F_CB value = [](Index, Number* x, Bool, Number* f, UserDataPtr user) -> Bool {
    Counted& c = *static_cast<Counted*>(user);
    c.evaluate(x);
    *f = c.value;
    return TRUE;
  };
  const Eval_Grad_F_CB gradient = [](Index count, Number* x, Bool, Number* g, UserDataPtr user) -> Bool {
    Counted& c = *static_cast<Counted*>(user);
    c.evaluate(x);
    std::copy_n(c.gradient.begin(), count, g);
    return TRUE;
  };
  const Eval_G_CB rows = [](Index, Number* x, Bool, Index count, Number* g, UserDataPtr user) -> Bool {
    const Problem& p = static_cast<Counted*>(user)->problem;
    for (Index i = 0; i < count; ++i) {
      const std::size_t row = static_cast<std::size_t>(i);
      g[i] = 0;
      for (std::size_t k = p.row_start[row]; k < p.row_start[row + 1]; ++k)
        g[i] += p.value[k] * x[p.column[k]];
    }
    return TRUE;
  };
  const Eval_Jac_G_CB jacobian = [](Index, Number*, Bool, Index, Index, Index* row, Index* column, Number* values,
                                    UserDataPtr user) -> Bool {
    const Problem& p = static_cast<Counted*>(user)->problem;
    for (std::size_t i = 0; i < p.rows(); ++i) {
      for (std::size_t k = p.row_start[i]; k < p.row_start[i + 1]; ++k) {
        if (values != nullptr) {
          values[k] = p.value[k];
        } else {
          row[k] = static_cast<Index>(i);
          column[k] = static_cast<Index>(p.column[k]);
        }
      }
    }
    return TRUE;
  };
  const Eval_H_CB hessian = [](Index, Number*, Bool, Number, Index, Number*, Bool, Index, Index*, Index*, Number*,
                               UserDataPtr) -> Bool { return FALSE; };
  const IpoptProblem solver =
      CreateIpoptProblem(n, lower.data(), upper.data(), m, rhs.data(), rhs.data(),
                         static_cast<Index>(problem.column.size()), 0, 0, value, rows, gradient, jacobian, hessian);
  const auto text = [&](std::string name, std::string setting) {
    AddIpoptStrOption(solver, name.data(), setting.data());
  };
  const auto number = [&](std::string name, double setting) { AddIpoptNumOption(solver, name.data(), setting); };
  const auto integer = [&](std::string name, int setting) { AddIpoptIntOption(solver, name.data(), setting); };
  text("hessian_approximation", "limited-memory");
  integer("limited_memory_max_history", 10);
  number("tol", 1e-8);
  integer("print_level", 0);
  text("sb", "yes");
  integer("max_iter", static_cast<int>(evaluation_limit));
  number("max_cpu_time", seconds_limit);
  number("bound_relax_factor", 0);
  Outcome outcome;
  outcome.x = problem.start;
  double best = 0;
  IpoptSolve(solver, outcome.x.data(), nullptr, &best, nullptr, nullptr, nullptr, &counted);
  FreeIpoptProblem(solver);
  outcome.evaluations = counted.count;
  outcome.seconds = seconds_since(start);
  return outcome;
}

#else

bool has_ipopt() {
  return false;
}

std::optional<Outcome> run_ipopt(const Problem&, std::size_t, double) {
  return std::nullopt;
}

#endif

}  // namespace orbicube::bench
