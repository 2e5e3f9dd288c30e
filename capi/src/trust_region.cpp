#include "orbicube/trust_region.h"

#include <limits>
#include <memory>
#include <span>

#include "base/version.h"
#include "capi/src/entry.h"
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

obc_trust_region_options default_options() {
  const tr::Options from;
  obc_trust_region_options options{};
  options.struct_size = sizeof options;
  options.method = static_cast<int32_t>(from.method);
  options.start = static_cast<int32_t>(from.start);
  options.points = from.points;
  options.radius_begin = from.radius_begin;
  options.radius_end = from.radius_end;
  options.target = from.target;
  options.noise_absolute = from.noise_absolute;
  options.noise_relative = from.noise_relative;
  options.restarts = from.restarts;
  options.max_evaluations = from.max_evaluations;
  return options;
}

tr::Options to_options(const obc_trust_region_options* given) {
  const obc_trust_region_options from = capi::copy_versioned(given, default_options());
  tr::Options options;
  options.method = static_cast<tr::Method>(from.method);
  options.start = static_cast<tr::Start>(from.start);
  options.points = from.points;
  options.radius_begin = from.radius_begin;
  options.radius_end = from.radius_end;
  options.target = from.target;
  options.noise_absolute = from.noise_absolute;
  options.noise_relative = from.noise_relative;
  options.restarts = from.restarts;
  options.max_evaluations = from.max_evaluations;
  return options;
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

const obc_trust_region& checked(const obc_trust_region* solver) {
  capi::require(solver != nullptr, "solver is NULL");
  return *solver;
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
    checked(solver);
    capi::require(count == 0 || (points != nullptr && outputs != nullptr), "points or outputs is NULL");
    tr::Solver& to = solver->solver;
    for (size_t i = 0; i < count; ++i)
      to.give({points + i * to.size(), to.size()}, {outputs + i * to.outputs(), to.outputs()});
  });
}

int32_t obc_trust_region_step(obc_trust_region* solver, const double** points, size_t* count) {
  if (solver == nullptr) return OBC_INVALID_ARGUMENT;
  tr::Request request{};
  const obc_status status = capi::guarded(nullptr, [&] { request = solver->solver.step(); });
  if (status != OBC_OK) return status;
  if (points != nullptr) *points = solver->solver.pending().data();
  if (count != nullptr) *count = solver->solver.pending_count();
  return static_cast<int32_t>(request);
}

obc_status obc_trust_region_tell(obc_trust_region* solver, const double* outputs, obc_error* error) {
  return capi::guarded(error, [&] {
    checked(solver);
    if (outputs != nullptr) {
      solver->solver.tell({outputs, solver->solver.outputs()});
    } else {
      solver->solver.tell_failure();
    }
  });
}

obc_status obc_trust_region_get_result(const obc_trust_region* solver, obc_trust_region_result* result, double* x,
                                       double* outputs, obc_error* error) {
  return capi::guarded(error, [&] { copy_result(checked(solver).solver, result, x, outputs); });
}

size_t obc_trust_region_save_size(const obc_trust_region* solver) {
  return solver != nullptr ? solver->solver.save_size() : 0;
}

obc_status obc_trust_region_save(const obc_trust_region* solver, void* blob, size_t capacity, obc_error* error) {
  return capi::guarded(error, [&] {
    const tr::Solver& from = checked(solver).solver;
    capi::require(blob != nullptr && capacity >= from.save_size(), "blob is NULL or too small");
    from.save({static_cast<std::byte*>(blob), from.save_size()});
  });
}

obc_status obc_trust_region_load(const obc_trust_region_problem* problem, const void* blob, size_t size,
                                 const obc_host* host, obc_trust_region** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr && blob != nullptr, "blob or out is NULL");
    *out = nullptr;
    const std::span<const std::byte> bytes(static_cast<const std::byte*>(blob), size);
    const tr::Options options = tr::Solver::options_of(bytes);
    auto loaded = std::make_unique<obc_trust_region>(host, to_problem(problem), options, std::span<const double>());
    loaded->solver.load(bytes);
    *out = loaded.release();
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
    for (tr::Request request; (request = run.solver.step()) != tr::Request::done;) {
      if (request != tr::Request::need_values) continue;
      std::fill(outputs.begin(), outputs.end(), std::numeric_limits<double>::quiet_NaN());
      const int32_t answer = f(run.solver.pending().data(), n, outputs.data(), user);
      if (answer == OBC_TRUST_REGION_FAILED) {
        run.solver.tell_failure();
      } else if (answer == OBC_TRUST_REGION_CONTINUE) {
        run.solver.tell(outputs);
      } else {
        run.solver.cancel();
      }
    }
    copy_result(run.solver, result, x, nullptr);
    if (run.solver.cancelled_by_host()) throw base::Error("cancelled", "stopped by the host");
  });
}

const char* obc_trust_region_stop_name(int32_t stop) {
  return tr::stop_name(static_cast<tr::Stop>(stop));
}

uint32_t obc_trust_region_version(void) {
  return static_cast<uint32_t>(base::version_major * 10000 + base::version_minor * 100 + base::version_patch);
}
