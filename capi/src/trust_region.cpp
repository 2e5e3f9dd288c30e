#include "orbicube/trust_region.h"

#include <limits>
#include <memory>
#include <span>

#include "base/sums.h"
#include "capi/src/solver_entry.h"
#include "trust_region/solver.h"

using namespace orbicube;
namespace tr = orbicube::trust_region;

struct obc_trust_region {
  obc_trust_region(const obc_host* host, const tr::Problem& problem, const tr::Options& options,
                   std::span<const double> start)
      : adapter(host), solver(problem, options, start, adapter.host()) {}
  capi::HostAdapter adapter;
  tr::Solver solver;
};

namespace {

static_assert(OBC_TRUST_REGION_CONTINUE == capi::answer_continue && OBC_TRUST_REGION_STOP == capi::answer_stop &&
              OBC_TRUST_REGION_FAILED == capi::answer_failed);

// The members that both have, either way round.
template <class To, class From>
To converted(To to, const From& from) {
  capi::assign(to.method, from.method);
  capi::assign(to.start, from.start);
  capi::assign(to.points, from.points);
  capi::assign(to.radius_begin, from.radius_begin);
  capi::assign(to.radius_end, from.radius_end);
  capi::assign(to.target, from.target);
  capi::assign(to.noise_absolute, from.noise_absolute);
  capi::assign(to.noise_relative, from.noise_relative);
  capi::assign(to.restarts, from.restarts);
  capi::assign(to.max_evaluations, from.max_evaluations);
  return to;
}

obc_trust_region_options default_options() {
  obc_trust_region_options options{};
  options.struct_size = sizeof options;
  return converted(options, tr::Options{});
}

tr::Options to_options(const obc_trust_region_options* given) {
  return converted(tr::Options{}, capi::copy_versioned(given, default_options()));
}

tr::Problem to_problem(const obc_trust_region_problem* given) {
  capi::require(given != nullptr, "problem is NULL");
  obc_trust_region_problem defaults{};
  defaults.struct_size = sizeof defaults;
  const obc_trust_region_problem from = capi::copy_versioned(given, defaults);
  tr::Problem problem;
  problem.n = from.n;
  problem.residuals = from.residuals;
  if (from.lower != nullptr) problem.lower = {from.lower, from.n};
  if (from.upper != nullptr) problem.upper = {from.upper, from.n};
  if (from.scale != nullptr) problem.scale = {from.scale, from.n};
  if (from.sign != nullptr) problem.sign = {from.sign, from.residuals};
  capi::assign(problem.objective, from.objective);
  return problem;
}

obc_trust_region_result to_result(const tr::Result& from) {
  obc_trust_region_result result{};
  result.stop = static_cast<int32_t>(from.stop);
  result.value = from.value;
  result.radius = from.radius;
  result.resolution = from.resolution;
  result.evaluations = from.evaluations;
  result.failed_evaluations = from.failed_evaluations;
  result.iterations = from.iterations;
  result.restarts = from.restarts;
  result.points = from.points;
  result.rebuilds = from.rebuilds;
  return result;
}

void copy_result(const tr::Solver& solver, obc_trust_region_result* result, double* x, double* outputs) {
  if (result != nullptr) capi::write_versioned(result, to_result(solver.result()));
  if (x != nullptr) std::copy(solver.best_point().begin(), solver.best_point().end(), x);
  if (outputs != nullptr) std::copy(solver.best_outputs().begin(), solver.best_outputs().end(), outputs);
}

}  // namespace

obc_status obc_trust_region_problem_init(obc_trust_region_problem* problem, size_t struct_size) {
  return capi::init_versioned(problem, struct_size, obc_trust_region_problem{});
}

obc_status obc_trust_region_options_init(obc_trust_region_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_trust_region_create(const obc_trust_region_problem* problem, const obc_trust_region_options* options,
                                   const double* x0, const obc_host* host, obc_trust_region** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr && x0 != nullptr, "x0 or out is NULL");
    *out = nullptr;
    const tr::Problem translated = to_problem(problem);
    *out = new obc_trust_region(host, translated, to_options(options), {x0, translated.n});
  });
}

obc_status obc_trust_region_give(obc_trust_region* solver, const double* points, const double* outputs, size_t count,
                                 obc_error* error) {
  return capi::guarded(error, [&] {
    capi::checked(solver);
    capi::require(count == 0 || (points != nullptr && outputs != nullptr), "points or outputs is NULL");
    tr::Solver& to = solver->solver;
    for (size_t i = 0; i < count; ++i)
      to.give({points + i * to.size(), to.size()}, {outputs + i * to.outputs(), to.outputs()});
  });
}

int32_t obc_trust_region_step(obc_trust_region* solver, const double** points, size_t* count) {
  return capi::step(solver, [&](const auto& asking) {
    if (points != nullptr) *points = asking.pending().data();
    if (count != nullptr) *count = asking.pending_count();
  });
}

obc_status obc_trust_region_tell(obc_trust_region* solver, const double* outputs, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::checked(solver);
    if (outputs != nullptr) {
      solver->solver.tell({outputs, solver->solver.outputs()});
    } else {
      solver->solver.tell_failure();
    }
  });
}

obc_status obc_trust_region_get_result(const obc_trust_region* solver, obc_trust_region_result* result, double* x,
                                       double* outputs, obc_error* error) {
  return capi::guarded(error, [&] { copy_result(capi::checked(solver).solver, result, x, outputs); });
}

size_t obc_trust_region_save_size(const obc_trust_region* solver) {
  return capi::save_size(solver);
}

obc_status obc_trust_region_save(const obc_trust_region* solver, void* blob, size_t capacity, obc_error* error) {
  return capi::save(solver, blob, capacity, error);
}

obc_status obc_trust_region_load(const obc_trust_region_problem* problem, const void* blob, size_t size,
                                 const obc_host* host, obc_trust_region** out, obc_error* error) {
  return capi::load(blob, size, out, error, [&](std::span<const std::byte> bytes) {
    return std::make_unique<obc_trust_region>(host, to_problem(problem), tr::Solver::options_of(bytes),
                                              std::span<const double>());
  });
}

void obc_trust_region_destroy(obc_trust_region* solver) {
  delete solver;
}

obc_status obc_trust_region_minimize(const obc_trust_region_problem* problem, const obc_trust_region_options* options,
                                     obc_trust_region_function f, void* user, double* x,
                                     obc_trust_region_result* result, const obc_host* host, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(f != nullptr && x != nullptr, "f or x is NULL");
    const tr::Problem translated = to_problem(problem);
    const std::size_t n = translated.n;
    obc_trust_region run(host, translated, to_options(options), {x, n});
    base::Array<double> outputs(translated.outputs(), 0.0, run.adapter.host().memory);
    capi::drive(
        run.solver,
        [&](const tr::Solver& asking) {
          std::fill(outputs.begin(), outputs.end(), std::numeric_limits<double>::quiet_NaN());
          return f(asking.pending().data(), n, outputs.data(), user);
        },
        [&](tr::Solver& asking) { asking.tell(outputs); },
        [&](tr::Solver& asking) {
          if (base::all_finite(outputs)) asking.tell(outputs);
        });
    copy_result(run.solver, result, x, nullptr);
    capi::throw_if_cancelled(run.solver.cancelled_by_host());
  });
}

const char* obc_trust_region_stop_name(int32_t stop) {
  return tr::stop_name(static_cast<tr::Stop>(stop));
}

uint32_t obc_trust_region_version(void) {
  return base::version_number;
}
