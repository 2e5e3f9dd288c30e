#include "orbicube/projected_gradient.h"

#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <span>

#include "capi/src/solver_entry.h"
#include "projected_gradient/gradient_check.h"
#include "projected_gradient/solver.h"

using namespace orbicube;
namespace pg = orbicube::projected_gradient;

struct obc_projected_gradient {
  obc_projected_gradient(const obc_host* host, const pg::Problem& problem, const pg::Options& options,
                         std::span<const double> start)
      : adapter(host), solver(problem, options, start, adapter.host()) {}
  capi::HostAdapter adapter;
  pg::Solver solver;
};

namespace {

static_assert(OBC_PROJECTED_GRADIENT_CONTINUE == capi::answer_continue &&
              OBC_PROJECTED_GRADIENT_STOP == capi::answer_stop && OBC_PROJECTED_GRADIENT_FAILED == capi::answer_failed);

// The members that both have, either way round.
template <class To, class From>
To converted(To to, const From& from) {
  capi::assign(to.method, from.method);
  capi::assign(to.line_search, from.line_search);
  capi::assign(to.memory, from.memory);
  capi::assign(to.history, from.history);
  capi::assign(to.average_weight, from.average_weight);
  capi::assign(to.gradient_tolerance, from.gradient_tolerance);
  capi::assign(to.target, from.target);
  capi::assign(to.max_evaluations, from.max_evaluations);
  capi::assign(to.max_iterations, from.max_iterations);
  return to;
}

obc_projected_gradient_options default_options() {
  obc_projected_gradient_options options{};
  options.struct_size = sizeof options;
  return converted(options, pg::Options{});
}

pg::Options to_options(const obc_projected_gradient_options* given) {
  return converted(pg::Options{}, capi::copy_versioned(given, default_options()));
}

pg::Problem to_problem(const obc_projected_gradient_problem* given) {
  capi::require(given != nullptr, "problem is NULL");
  obc_projected_gradient_problem defaults{};
  defaults.struct_size = sizeof defaults;
  const obc_projected_gradient_problem from = capi::copy_versioned(given, defaults);
  capi::require(from.n >= 1 && from.n < std::numeric_limits<std::uint32_t>::max(), "n must be from 1 to 4294967294");
  capi::require(from.m < std::numeric_limits<std::uint32_t>::max(), "there are too many rows");
  pg::Problem problem;
  problem.n = from.n;
  if (from.lower != nullptr) problem.lower = {from.lower, from.n};
  if (from.upper != nullptr) problem.upper = {from.upper, from.n};
  if (from.m > 0) {
    capi::require(from.row_start != nullptr && from.b != nullptr, "row_start or b is NULL");
    const std::size_t entries = from.row_start[from.m];
    capi::require(entries == 0 || (from.column != nullptr && from.value != nullptr), "column or value is NULL");
    problem.row_start = {from.row_start, from.m + 1};
    problem.column = {from.column, entries};
    problem.value = {from.value, entries};
    problem.rhs = {from.b, from.m};
  }
  if (from.project != nullptr) {
    // Two pointers and a count do not fit into a std::function without an allocation, which is made here and freed with
    // the problem.
    problem.project = [call = from.project, user = from.project_user, n = from.n](const double* y, double* x) {
      return call(y, n, x, user) == 0;
    };
  }
  return problem;
}

obc_projected_gradient_result to_result(const pg::Result& from) {
  obc_projected_gradient_result result{};
  result.stop = static_cast<int32_t>(from.stop);
  result.value = from.value;
  result.projected_gradient = from.projected_gradient;
  result.equality_residual = from.equality_residual;
  result.evaluations = from.evaluations;
  result.failed_evaluations = from.failed_evaluations;
  result.iterations = from.iterations;
  result.projection_passes = from.projection_passes;
  result.certificate_gap = from.certificate_gap;
  return result;
}

void copy_result(const pg::Solver& solver, obc_projected_gradient_result* result, double* x) {
  if (result != nullptr) capi::write_versioned(result, to_result(solver.result()));
  const std::span<const double> best = solver.best_point();
  if (x != nullptr) std::copy(best.begin(), best.end(), x);
}

}  // namespace

obc_status obc_projected_gradient_problem_init(obc_projected_gradient_problem* problem, size_t struct_size) {
  return capi::init_versioned(problem, struct_size, obc_projected_gradient_problem{});
}

obc_status obc_projected_gradient_options_init(obc_projected_gradient_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_projected_gradient_create(const obc_projected_gradient_problem* problem,
                                         const obc_projected_gradient_options* options, const double* x0,
                                         const obc_host* host, obc_projected_gradient** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr && x0 != nullptr, "x0 or out is NULL");
    *out = nullptr;
    const pg::Problem translated = to_problem(problem);
    *out = new obc_projected_gradient(host, translated, to_options(options), {x0, translated.n});
  });
}

int32_t obc_projected_gradient_step(obc_projected_gradient* solver, const double** x) {
  return capi::step(solver, [&](const auto& asking) {
    if (x != nullptr) *x = asking.point().data();
  });
}

obc_status obc_projected_gradient_tell(obc_projected_gradient* solver, double value, const double* gradient,
                                       obc_error* error) {
  return capi::tell_gradient(solver, value, gradient, error);
}

obc_status obc_projected_gradient_get_result(const obc_projected_gradient* solver,
                                             obc_projected_gradient_result* result, double* x, obc_error* error) {
  return capi::guarded(error, [&] { copy_result(capi::checked(solver).solver, result, x); });
}

obc_status obc_projected_gradient_multipliers(const obc_projected_gradient* solver, double* multipliers,
                                              obc_error* error) {
  return capi::guarded(error, [&] {
    const pg::Solver& from = capi::checked(solver).solver;
    capi::require(from.rows() == 0 || multipliers != nullptr, "multipliers is NULL");
    from.copy_multipliers({multipliers, from.rows()});
  });
}

obc_status obc_projected_gradient_certificate(const obc_projected_gradient* solver, double* certificate,
                                              obc_error* error) {
  return capi::guarded(error, [&] {
    const pg::Solver& from = capi::checked(solver).solver;
    capi::require(from.result().stop == pg::Stop::infeasible, "the constraints were not found infeasible");
    capi::require(certificate != nullptr, "certificate is NULL");
    std::copy(from.certificate().begin(), from.certificate().end(), certificate);
  });
}

size_t obc_projected_gradient_save_size(const obc_projected_gradient* solver) {
  return capi::save_size(solver);
}

obc_status obc_projected_gradient_save(const obc_projected_gradient* solver, void* blob, size_t capacity,
                                       obc_error* error) {
  return capi::save(solver, blob, capacity, error);
}

obc_status obc_projected_gradient_load(const obc_projected_gradient_problem* problem, const void* blob, size_t size,
                                       const obc_host* host, obc_projected_gradient** out, obc_error* error) {
  return capi::load(blob, size, out, error, [&](std::span<const std::byte> bytes) {
    return std::make_unique<obc_projected_gradient>(host, to_problem(problem), pg::Solver::options_of(bytes),
                                                    std::span<const double>());
  });
}

void obc_projected_gradient_destroy(obc_projected_gradient* solver) {
  delete solver;
}

obc_status obc_projected_gradient_minimize(const obc_projected_gradient_problem* problem,
                                           const obc_projected_gradient_options* options,
                                           obc_projected_gradient_function f, void* user, double* x,
                                           obc_projected_gradient_result* result, const obc_host* host,
                                           obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(f != nullptr && x != nullptr, "f or x is NULL");
    const pg::Problem translated = to_problem(problem);
    const std::size_t n = translated.n;
    obc_projected_gradient run(host, translated, to_options(options), {x, n});
    capi::drive_gradient(run.solver, run.adapter.host().memory, [&](const double* at, double* value, double* gradient) {
      return f(at, n, value, gradient, user);
    });
    copy_result(run.solver, result, x);
    capi::throw_if_cancelled(run.solver.cancelled_by_host());
  });
}

obc_status obc_projected_gradient_project(const obc_projected_gradient_problem* problem, const double* y, double* x,
                                          double* multipliers, obc_projected_gradient_result* result,
                                          const obc_host* host, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(y != nullptr && x != nullptr && x != y, "y or x is NULL, or they are the same");
    const capi::HostAdapter adapter(host);
    const pg::Problem translated = to_problem(problem);
    for (std::size_t j = 0; j < translated.n; ++j)
      capi::require(std::abs(y[j]) <= pg::max_coordinate, "y is not finite, or beyond 1e150");
    pg::FeasibleSet set(translated, adapter.host().memory);
    const std::span<double> to(x, translated.n);
    const pg::Projected outcome = set.project({y, translated.n}, to, 1, adapter.host());
    pg::Result report;
    report.projection_passes = set.passes();
    report.certificate_gap = set.certificate_gap();
    report.stop = outcome == pg::Projected::done         ? pg::Stop::converged
                  : outcome == pg::Projected::infeasible ? pg::Stop::infeasible
                                                         : pg::Stop::projection_failed;
    if (outcome == pg::Projected::done) report.equality_residual = set.relative_residual(to);
    if (multipliers != nullptr) {
      for (std::size_t i = 0; i < set.rows(); ++i) {
        multipliers[i] =
            outcome == pg::Projected::infeasible ? set.certificate()[i] : set.guess()[i] * set.linear_rows().scale(i);
      }
    }
    if (result != nullptr) capi::write_versioned(result, to_result(report));
  });
}

obc_status obc_projected_gradient_check_gradient(const obc_projected_gradient_problem* problem,
                                                 obc_projected_gradient_function f, void* user, const double* x,
                                                 obc_projected_gradient_check* check, const obc_host* host,
                                                 obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(f != nullptr && x != nullptr && check != nullptr, "f, x or check is NULL");
    const capi::HostAdapter adapter(host);
    const pg::Problem translated = to_problem(problem);
    const std::size_t n = translated.n;
    base::Array<double> spare(n, 0.0, adapter.host().memory);
    const auto evaluate = [&](const double* at, double* gradient) {
      double value = std::numeric_limits<double>::quiet_NaN();
      const int32_t answer = f(at, n, &value, gradient != nullptr ? gradient : spare.data(), user);
      if (answer == capi::answer_failed) return std::numeric_limits<double>::quiet_NaN();
      if (answer != capi::answer_continue) throw base::Error("cancelled", "stopped by the callback");
      return value;
    };
    const pg::GradientCheck found = pg::check_gradient(translated, {x, n}, evaluate, adapter.host());
    obc_projected_gradient_check result{};
    result.agrees = found.agrees ? 1 : 0;
    result.worst = found.worst;
    result.told = found.told;
    result.difference = found.difference;
    result.error = found.error;
    result.uncertainty = found.uncertainty;
    result.compared = found.compared;
    result.evaluations = found.evaluations;
    capi::write_versioned(check, result);
  });
}

const char* obc_projected_gradient_stop_name(int32_t stop) {
  return pg::stop_name(static_cast<pg::Stop>(stop));
}

uint32_t obc_projected_gradient_version(void) {
  return base::version_number;
}
