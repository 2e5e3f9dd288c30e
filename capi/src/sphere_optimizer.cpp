#include "orbicube/sphere_optimizer.h"

#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include "base/version.h"
#include "capi/src/entry.h"
#include "sphere_optimizer/relaxation.h"
#include "sphere_optimizer/solver.h"

using namespace orbicube;
namespace so = orbicube::sphere_optimizer;

struct obc_sphere_optimizer {
  obc_sphere_optimizer(const obc_host* host, const so::Shape& shape, const so::Options& options,
                       std::span<const double> start)
      : adapter(host), solver(shape, options, start, adapter.host()) {}
  capi::HostAdapter adapter;
  so::Solver solver;
};

namespace {

obc_sphere_optimizer_options default_options() {
  const so::Options from;
  obc_sphere_optimizer_options options{};
  options.struct_size = sizeof options;
  options.method = static_cast<int32_t>(from.method);
  options.memory = from.memory;
  options.history = from.history;
  options.gradient_tolerance = from.gradient_tolerance;
  options.target = from.target;
  options.max_evaluations = from.max_evaluations;
  options.max_iterations = from.max_iterations;
  return options;
}

so::Options to_options(const obc_sphere_optimizer_options* given) {
  const obc_sphere_optimizer_options from = capi::copy_versioned(given, default_options());
  so::Options options;
  options.method = static_cast<so::Method>(from.method);
  options.memory = from.memory;
  options.history = from.history;
  options.gradient_tolerance = from.gradient_tolerance;
  options.target = from.target;
  options.max_evaluations = from.max_evaluations;
  options.max_iterations = from.max_iterations;
  return options;
}

void copy_result(const so::Solver& solver, obc_sphere_optimizer_result* result, double* x) {
  if (result != nullptr) {
    const so::Result from = solver.result();
    obc_sphere_optimizer_result to{};
    to.stop = static_cast<int32_t>(from.stop);
    to.value = from.value;
    to.gradient_norm = from.gradient_norm;
    to.evaluations = from.evaluations;
    to.failed_evaluations = from.failed_evaluations;
    to.iterations = from.iterations;
    capi::write_versioned(result, to);
  }
  const std::span<const double> best = solver.best_point();
  if (x != nullptr) std::copy(best.begin(), best.end(), x);
}

const obc_sphere_optimizer& checked(const obc_sphere_optimizer* solver) {
  capi::require(solver != nullptr, "solver is NULL");
  return *solver;
}

// The number of unknowns, which the solver checks again; here so that x0 can be looked at.
so::Shape to_shape(size_t count, size_t dimension) {
  capi::require(count >= 1 && dimension >= 2 && count <= std::numeric_limits<size_t>::max() / dimension,
                "there must be a sphere, in two dimensions at least");
  return {count, dimension};
}

obc_sphere_optimizer_relaxation_options default_relaxation_options() {
  const so::RelaxationOptions from;
  obc_sphere_optimizer_relaxation_options options{};
  options.struct_size = sizeof options;
  options.method = static_cast<int32_t>(from.method);
  options.gradient_tolerance = from.gradient_tolerance;
  options.relative_gain = from.relative_gain;
  options.max_passes = from.max_passes;
  return options;
}

obc_sphere_optimizer_blocks checked_blocks(const obc_sphere_optimizer_blocks* given) {
  capi::require(given != nullptr, "blocks is NULL");
  obc_sphere_optimizer_blocks defaults{};
  defaults.struct_size = sizeof defaults;
  const obc_sphere_optimizer_blocks blocks = capi::copy_versioned(given, defaults);
  capi::require(blocks.count >= 1 && blocks.count < std::numeric_limits<std::uint32_t>::max(),
                "count must be from 1 to 4294967294");
  capi::require(blocks.dimension >= 2 && blocks.dimension <= so::largest_block_dimension,
                "dimension must be from 2 to 64");
  capi::require(blocks.neighbour_start != nullptr && blocks.neighbour_start[0] == 0,
                "neighbour_start must begin with 0");
  for (std::size_t i = 0; i < blocks.count; ++i)
    capi::require(blocks.neighbour_start[i] <= blocks.neighbour_start[i + 1], "neighbour_start must not fall");
  const std::size_t entries = blocks.neighbour_start[blocks.count];
  capi::require(entries == 0 || blocks.neighbour != nullptr, "neighbour is NULL");
  for (std::size_t k = 0; k < entries; ++k)
    capi::require(blocks.neighbour[k] < blocks.count, "a neighbour is out of range");
  return blocks;
}

// An energy whose parts a callback gives; the answer to stop it becomes an Error "cancelled".
template <class Dimension>
class CallbackEnergy {
 public:
  CallbackEnergy(Dimension dimension, const obc_sphere_optimizer_blocks& blocks, obc_sphere_optimizer_block_function f,
                 void* user, const double* points)
      : dimension_(dimension), blocks_(blocks), f_(f), user_(user), points_(points) {}

  Dimension dimension() const { return dimension_; }
  double value(std::size_t block, const double* place) const { return call(block, place, nullptr, nullptr); }
  double value_and_gradient(std::size_t block, double* gradient) const {
    return call(block, points_ + block * dimension_, gradient, nullptr);
  }
  template <class Visit>
  void for_each_neighbour(std::size_t block, const Visit& visit) const {
    for (std::size_t k = blocks_.neighbour_start[block]; k < blocks_.neighbour_start[block + 1]; ++k)
      visit(blocks_.neighbour[k]);
  }
  bool stopped() const { return stopped_; }

 protected:
  double call(std::size_t block, const double* place, double* gradient, double* hessian) const {
    double value = std::numeric_limits<double>::quiet_NaN();
    const int32_t answer = f_(block, place, points_, &value, gradient, hessian, user_);
    if (answer == OBC_SPHERE_OPTIMIZER_CONTINUE) return value;
    if (answer == OBC_SPHERE_OPTIMIZER_FAILED) return std::numeric_limits<double>::quiet_NaN();
    stopped_ = true;
    throw base::Error("cancelled", "stopped by the callback");
  }

  Dimension dimension_;
  const obc_sphere_optimizer_blocks& blocks_;
  obc_sphere_optimizer_block_function f_;
  void* user_;
  const double* points_;
  mutable bool stopped_ = false;
};

template <class Dimension>
class SecondOrderCallbackEnergy : public CallbackEnergy<Dimension> {
 public:
  using CallbackEnergy<Dimension>::CallbackEnergy;
  double value_gradient_and_hessian(std::size_t block, double* gradient, double* hessian) const {
    return this->call(block, this->points_ + block * this->dimension_, gradient, hessian);
  }
};

}  // namespace

obc_status obc_sphere_optimizer_options_init(obc_sphere_optimizer_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_sphere_optimizer_create(size_t count, size_t dimension, const obc_sphere_optimizer_options* options,
                                       const double* x0, const obc_host* host, obc_sphere_optimizer** out,
                                       obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr && x0 != nullptr, "x0 or out is NULL");
    *out = nullptr;
    const so::Shape shape = to_shape(count, dimension);
    *out = new obc_sphere_optimizer(host, shape, to_options(options), {x0, shape.size()});
  });
}

int32_t obc_sphere_optimizer_step(obc_sphere_optimizer* solver, const double** x) {
  if (solver == nullptr) return OBC_INVALID_ARGUMENT;
  so::Request request{};
  const obc_status status = capi::guarded(nullptr, [&] { request = solver->solver.step(); });
  if (status != OBC_OK) return status;
  if (x != nullptr) *x = solver->solver.point().data();
  return static_cast<int32_t>(request);
}

obc_status obc_sphere_optimizer_tell(obc_sphere_optimizer* solver, double value, const double* gradient,
                                     obc_error* error) {
  return capi::guarded(error, [&] {
    checked(solver);
    if (gradient != nullptr) {
      solver->solver.tell(value, {gradient, solver->solver.shape().size()});
    } else {
      capi::require(!std::isfinite(value), "gradient is NULL");
      solver->solver.tell_failure();
    }
  });
}

obc_status obc_sphere_optimizer_get_result(const obc_sphere_optimizer* solver, obc_sphere_optimizer_result* result,
                                           double* x, obc_error* error) {
  return capi::guarded(error, [&] { copy_result(checked(solver).solver, result, x); });
}

size_t obc_sphere_optimizer_save_size(const obc_sphere_optimizer* solver) {
  return solver != nullptr ? solver->solver.save_size() : 0;
}

obc_status obc_sphere_optimizer_save(const obc_sphere_optimizer* solver, void* blob, size_t capacity,
                                     obc_error* error) {
  return capi::guarded(error, [&] {
    const so::Solver& from = checked(solver).solver;
    capi::require(blob != nullptr && capacity >= from.save_size(), "blob is NULL or too small");
    from.save({static_cast<std::byte*>(blob), from.save_size()});
  });
}

obc_status obc_sphere_optimizer_load(const void* blob, size_t size, const obc_host* host, obc_sphere_optimizer** out,
                                     obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr && blob != nullptr, "blob or out is NULL");
    *out = nullptr;
    const std::span<const std::byte> bytes(static_cast<const std::byte*>(blob), size);
    auto loaded = std::make_unique<obc_sphere_optimizer>(host, so::Solver::shape_of(bytes),
                                                         so::Solver::options_of(bytes), std::span<const double>());
    loaded->solver.load(bytes);
    *out = loaded.release();
  });
}

void obc_sphere_optimizer_destroy(obc_sphere_optimizer* solver) {
  delete solver;
}

obc_status obc_sphere_optimizer_minimize(size_t count, size_t dimension, const obc_sphere_optimizer_options* options,
                                         obc_sphere_optimizer_function f, void* user, double* x,
                                         obc_sphere_optimizer_result* result, const obc_host* host, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(f != nullptr && x != nullptr, "f or x is NULL");
    const so::Shape shape = to_shape(count, dimension);
    obc_sphere_optimizer run(host, shape, to_options(options), {x, shape.size()});
    base::Array<double> gradient(shape.size(), 0.0, run.adapter.host().memory);
    for (so::Request request; (request = run.solver.step()) != so::Request::done;) {
      if (request != so::Request::need_value_and_gradient) continue;
      double value = std::numeric_limits<double>::quiet_NaN();
      const int32_t answer = f(run.solver.point().data(), count, dimension, &value, gradient.data(), user);
      if (answer == OBC_SPHERE_OPTIMIZER_FAILED) {
        run.solver.tell_failure();
      } else if (answer == OBC_SPHERE_OPTIMIZER_CONTINUE) {
        run.solver.tell(value, gradient);
      } else {
        run.solver.cancel();
      }
    }
    copy_result(run.solver, result, x);
    if (run.solver.cancelled_by_host()) throw base::Error("cancelled", "stopped by the host");
  });
}

obc_status obc_sphere_optimizer_blocks_init(obc_sphere_optimizer_blocks* blocks, size_t struct_size) {
  return capi::init_versioned(blocks, struct_size, obc_sphere_optimizer_blocks{});
}

obc_status obc_sphere_optimizer_relaxation_options_init(obc_sphere_optimizer_relaxation_options* options,
                                                        size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_relaxation_options());
}

obc_status obc_sphere_optimizer_relax(const obc_sphere_optimizer_blocks* blocks,
                                      const obc_sphere_optimizer_relaxation_options* options,
                                      obc_sphere_optimizer_block_function f, void* user, double* x,
                                      obc_sphere_optimizer_relaxation_result* result, const obc_host* host,
                                      obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(f != nullptr && x != nullptr, "f or x is NULL");
    const obc_sphere_optimizer_blocks given = checked_blocks(blocks);
    const obc_sphere_optimizer_relaxation_options from = capi::copy_versioned(options, default_relaxation_options());
    capi::require(from.method == OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE || from.method == OBC_SPHERE_OPTIMIZER_SEED,
                  "method must be GREAT_CIRCLE or SEED");
    capi::require(from.gradient_tolerance >= 0 && from.relative_gain >= 0,
                  "gradient_tolerance and relative_gain must not be negative");
    const so::RelaxationOptions to{static_cast<so::Method>(from.method), from.gradient_tolerance, from.relative_gain,
                                   from.max_passes};
    const capi::HostAdapter adapter(host);
    so::RelaxationSpace space(given.count, adapter.host().memory);
    const std::span<double> points(x, given.count * given.dimension);
    so::RelaxationResult done;
    bool cancelled_by_host = false;
    so::with_dimension(given.dimension, [&](auto d) {
      for (std::size_t i = 0; i < given.count; ++i)
        capi::require(so::normalise(d, &points[i * d]), "a block of the start is zero or not finite");
      const auto run = [&](const auto& energy) {
        try {
          so::relax(energy, points, to, space, adapter.host(), done);
        } catch (const base::Error& stopped) {
          if (stopped.status() != base::Status::cancelled) throw;
          done.stop = so::Stop::cancelled;
          cancelled_by_host = !energy.stopped();
        }
      };
      if (from.second_order != 0) {
        run(SecondOrderCallbackEnergy<decltype(d)>(d, given, f, user, x));
      } else {
        run(CallbackEnergy<decltype(d)>(d, given, f, user, x));
      }
    });
    if (result != nullptr) {
      obc_sphere_optimizer_relaxation_result report{};
      report.stop = static_cast<int32_t>(done.stop);
      report.gain = done.gain;
      report.gradient_norm = done.gradient_norm;
      report.steps = done.steps;
      report.evaluations = done.evaluations;
      report.failed_steps = done.failed_steps;
      capi::write_versioned(result, report);
    }
    if (cancelled_by_host) throw base::Error("cancelled", "stopped by the host");
  });
}

const char* obc_sphere_optimizer_stop_name(int32_t stop) {
  return so::stop_name(static_cast<so::Stop>(stop));
}

uint32_t obc_sphere_optimizer_version(void) {
  return static_cast<uint32_t>(base::version_major * 10000 + base::version_minor * 100 + base::version_patch);
}
