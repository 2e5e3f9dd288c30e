#include "orbicube/sphere_optimizer.h"

#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include "base/hash.h"
#include "capi/src/solver_entry.h"
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

static_assert(OBC_SPHERE_OPTIMIZER_CONTINUE == capi::answer_continue &&
              OBC_SPHERE_OPTIMIZER_STOP == capi::answer_stop && OBC_SPHERE_OPTIMIZER_FAILED == capi::answer_failed);

// The members that both have, either way round.
template <class To, class From>
To converted(To to, const From& from) {
  capi::assign(to.method, from.method);
  capi::assign(to.memory, from.memory);
  capi::assign(to.history, from.history);
  capi::assign(to.gradient_tolerance, from.gradient_tolerance);
  capi::assign(to.target, from.target);
  capi::assign(to.max_evaluations, from.max_evaluations);
  capi::assign(to.max_iterations, from.max_iterations);
  capi::assign(to.starts, from.starts);
  capi::assign(to.seed, from.seed);
  capi::assign(to.hessian_products, from.hessian_products);
  return to;
}

obc_sphere_optimizer_options default_options() {
  obc_sphere_optimizer_options options{};
  options.struct_size = sizeof options;
  return converted(options, so::Options{});
}

so::Options to_options(const obc_sphere_optimizer_options* given) {
  return converted(so::Options{}, capi::copy_versioned(given, default_options()));
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
    to.starts = from.starts;
    to.best_start = from.best_start;
    to.products = from.products;
    capi::write_versioned(result, to);
  }
  const std::span<const double> best = solver.best_point();
  if (x != nullptr) std::copy(best.begin(), best.end(), x);
}

// The number of unknowns, which the solver checks again; here so that x0 can be looked at.
so::Shape to_shape(size_t count, size_t dimension) {
  capi::require(count >= 1 && dimension >= 2 && count <= std::numeric_limits<size_t>::max() / dimension,
                "there must be a sphere, in at least two dimensions");
  return {count, dimension};
}

// The reply of `product` to a request for a product of the Hessian.
void answer_product(so::Solver& solver, obc_sphere_optimizer_product_function product, void* user) {
  const so::Shape& shape = solver.shape();
  const std::span<double> room = solver.gradient_room();
  std::fill(room.begin(), room.end(), std::numeric_limits<double>::quiet_NaN());  // what is not set is not known
  const int32_t reply =
      product(solver.point().data(), solver.direction().data(), shape.count, shape.dimension, room.data(), user);
  if (reply == OBC_SPHERE_OPTIMIZER_CONTINUE) {
    solver.tell_product(room);
  } else {
    solver.tell_product_failure();
    if (reply != OBC_SPHERE_OPTIMIZER_FAILED) solver.cancel();
  }
}

// `product` is NULL unless the options want products.
void minimize(const so::Shape& shape, const so::Options& options, obc_sphere_optimizer_function f,
              obc_sphere_optimizer_product_function product, void* user, double* x, obc_sphere_optimizer_result* result,
              const obc_host* host) {
  obc_sphere_optimizer run(host, shape, options, {x, shape.size()});
  capi::drive_gradient(
      run.solver, run.adapter.host().memory,
      [&](const double* at, double* value, double* gradient) {
        return f(at, shape.count, shape.dimension, value, gradient, user);
      },
      [&](so::Solver& solver) { answer_product(solver, product, user); });
  copy_result(run.solver, result, x);
  capi::throw_if_cancelled(run.solver.cancelled_by_host());
}

template <class To, class From>
To converted_relaxation(To to, const From& from) {
  capi::assign(to.method, from.method);
  capi::assign(to.second_order, from.second_order);
  capi::assign(to.order, from.order);
  capi::assign(to.gradient_tolerance, from.gradient_tolerance);
  capi::assign(to.relative_gain, from.relative_gain);
  capi::assign(to.over_relaxation, from.over_relaxation);
  capi::assign(to.max_passes, from.max_passes);
  return to;
}

obc_sphere_optimizer_relaxation_options default_relaxation_options() {
  obc_sphere_optimizer_relaxation_options options{};
  options.struct_size = sizeof options;
  return converted_relaxation(options, so::RelaxationOptions{});
}

so::RelaxationOptions to_options(const obc_sphere_optimizer_relaxation_options* given) {
  return converted_relaxation(so::RelaxationOptions{}, capi::copy_versioned(given, default_relaxation_options()));
}

obc_sphere_optimizer_blocks checked_blocks(const obc_sphere_optimizer_blocks* given) {
  capi::require(given != nullptr, "blocks is NULL");
  obc_sphere_optimizer_blocks defaults{};
  defaults.struct_size = sizeof defaults;
  const obc_sphere_optimizer_blocks blocks = capi::copy_versioned(given, defaults);
  capi::require(blocks.count >= 1 && blocks.count < std::numeric_limits<std::uint32_t>::max(),
                "count must be from 1 to 4294967294");
  capi::require(blocks.dimension >= 2 && blocks.dimension <= so::max_block_dimension, "dimension must be from 2 to 64");
  capi::require(blocks.neighbor_start != nullptr && blocks.neighbor_start[0] == 0, "neighbor_start must begin with 0");
  for (std::size_t i = 0; i < blocks.count; ++i)
    capi::require(blocks.neighbor_start[i] <= blocks.neighbor_start[i + 1], "neighbor_start must not fall");
  const std::size_t entries = blocks.neighbor_start[blocks.count];
  capi::require(entries == 0 || blocks.neighbor != nullptr, "the member `neighbor` is NULL");
  for (std::size_t k = 0; k < entries; ++k)
    capi::require(blocks.neighbor[k] < blocks.count, "a neighbor is out of range");
  return blocks;
}

// Who is whose neighbor, in the caller's arrays or in copies of them.
struct Neighbors {
  std::span<const std::size_t> start;
  std::span<const std::uint32_t> list;
};

Neighbors neighbors_of(const obc_sphere_optimizer_blocks& blocks) {
  return {{blocks.neighbor_start, blocks.count + 1}, {blocks.neighbor, blocks.neighbor_start[blocks.count]}};
}

// An energy whose parts a callback gives; the return value STOP becomes an Error "cancelled".
template <class Dimension>
class CallbackEnergy {
 public:
  CallbackEnergy(Dimension dimension, const Neighbors& neighbors, obc_sphere_optimizer_block_function f, void* user,
                 const double* points)
      : dimension_(dimension), neighbors_(neighbors), f_(f), user_(user), points_(points) {}

  Dimension dimension() const { return dimension_; }
  double value(std::size_t block, const double* place) const { return call(block, place, nullptr, nullptr); }
  double value_and_gradient(std::size_t block, double* gradient) const {
    return call(block, points_ + block * dimension_, gradient, nullptr);
  }
  template <class Visit>
  void for_each_neighbor(std::size_t block, const Visit& visit) const {
    for (std::size_t k = neighbors_.start[block]; k < neighbors_.start[block + 1]; ++k)
      visit(neighbors_.list[k]);
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
  Neighbors neighbors_;
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

void normalize_blocks(const so::Shape& shape, double* x) {
  so::with_dimension(shape.dimension, [&](auto d) {
    for (std::size_t i = 0; i < shape.count; ++i)
      capi::require(so::normalize(d, x + i * d), "a block of the start is zero or not finite");
  });
}

// Goes on with a relaxation of the points at x. Returns how it stands; a host that cancelled is an Error.
so::Stop run_relaxation(so::Relaxation& relaxation, const Neighbors& neighbors, obc_sphere_optimizer_block_function f,
                        void* user, double* x, std::uint64_t steps, const base::Host& host) {
  return so::with_dimension(relaxation.shape().dimension, [&](auto d) {
    const auto run = [&](const auto& energy) {
      try {
        relaxation.run(energy, {x, relaxation.shape().size()}, host, steps);
        return relaxation.result().stop;
      } catch (const base::Error& error) {
        if (error.status() == base::Status::cancelled && energy.stopped()) return so::Stop::cancelled;
        throw;
      }
    };
    if (relaxation.options().second_order != 0) {
      return run(SecondOrderCallbackEnergy<decltype(d)>(d, neighbors, f, user, x));
    }
    return run(CallbackEnergy<decltype(d)>(d, neighbors, f, user, x));
  });
}

void copy_result(const so::RelaxationResult& from, so::Stop stop, obc_sphere_optimizer_relaxation_result* result) {
  if (result == nullptr) return;
  obc_sphere_optimizer_relaxation_result to{};
  to.stop = static_cast<int32_t>(stop);
  to.gain = from.gain;
  to.gradient_norm = from.gradient_norm;
  to.steps = from.steps;
  to.evaluations = from.evaluations;
  to.failed_steps = from.failed_steps;
  to.over_relaxation = from.over_relaxation;
  capi::write_versioned(result, to);
}

// Distinguishes one set of neighbors from another.
std::uint64_t fingerprint(const Neighbors& neighbors) {
  base::Hash hash;
  hash.add(std::as_bytes(neighbors.start));
  hash.add(std::as_bytes(neighbors.list));
  return hash.value();
}

// A relaxation with its points and neighbors, as capi::save and capi::load take it.
class OwnRelaxation {
 public:
  OwnRelaxation(const obc_sphere_optimizer_blocks& blocks, const so::RelaxationOptions& options, const base::Host& host)
      : host_(host),
        start_(neighbors_of(blocks).start.begin(), neighbors_of(blocks).start.end(), host.memory),
        list_(neighbors_of(blocks).list.begin(), neighbors_of(blocks).list.end(), host.memory),
        points_(blocks.count * blocks.dimension, 0.0, host.memory),
        relaxation_({blocks.count, blocks.dimension}, options, host.memory, fingerprint(neighbors_of(blocks))) {}

  void start_at(const double* x) {
    std::copy_n(x, points_.size(), points_.begin());
    normalize_blocks(relaxation_.shape(), points_.data());
  }
  void run(obc_sphere_optimizer_block_function f, void* user, std::uint64_t steps) {
    stop_ = so::Stop::cancelled;  // unless it is known better
    stop_ = run_relaxation(relaxation_, {start_, list_}, f, user, points_.data(), steps, host_);
  }
  const so::RelaxationResult& result() const { return relaxation_.result(); }
  so::Stop stop() const { return stop_; }
  std::span<const double> points() const { return points_; }

  std::size_t save_size() const { return relaxation_.save_size(); }
  void save(std::span<std::byte> blob) const { relaxation_.save(points_, blob); }
  void load(std::span<const std::byte> blob) {
    relaxation_.load(blob, points_);
    stop_ = relaxation_.result().stop;
  }

 private:
  const base::Host& host_;
  base::Array<std::size_t> start_;
  base::Array<std::uint32_t> list_;
  base::Array<double> points_;
  so::Relaxation relaxation_;
  so::Stop stop_ = so::Stop::running;
};

}  // namespace

struct obc_sphere_optimizer_relaxation {
  obc_sphere_optimizer_relaxation(const obc_host* host, const obc_sphere_optimizer_blocks& blocks,
                                  const so::RelaxationOptions& options)
      : adapter(host), solver(blocks, options, adapter.host()) {}
  capi::HostAdapter adapter;
  OwnRelaxation solver;
};

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
  return capi::step(solver, [&](const auto& asking) {
    if (x != nullptr) *x = asking.point().data();
  });
}

obc_status obc_sphere_optimizer_tell(obc_sphere_optimizer* solver, double value, const double* gradient,
                                     obc_error* error) {
  return capi::tell_gradient(solver, value, gradient, error);
}

obc_status obc_sphere_optimizer_get_direction(const obc_sphere_optimizer* solver, const double** direction,
                                              obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(direction != nullptr, "direction is NULL");
    *direction = nullptr;
    const so::Solver& asking = capi::checked(solver).solver;
    capi::require(asking.asks_product(), "no product was requested");
    *direction = asking.direction().data();
  });
}

obc_status obc_sphere_optimizer_tell_product(obc_sphere_optimizer* solver, const double* product, obc_error* error) {
  return capi::guarded(error, [&] {
    so::Solver& asking = capi::checked(solver).solver;
    if (product == nullptr) return asking.tell_product_failure();
    asking.tell_product({product, asking.point().size()});
  });
}

obc_status obc_sphere_optimizer_get_result(const obc_sphere_optimizer* solver, obc_sphere_optimizer_result* result,
                                           double* x, obc_error* error) {
  return capi::guarded(error, [&] { copy_result(capi::checked(solver).solver, result, x); });
}

obc_status obc_sphere_optimizer_get_shape(const obc_sphere_optimizer* solver, size_t* count, size_t* dimension,
                                          obc_error* error) {
  return capi::guarded(error, [&] {
    const so::Shape& shape = capi::checked(solver).solver.shape();
    if (count != nullptr) *count = shape.count;
    if (dimension != nullptr) *dimension = shape.dimension;
  });
}

size_t obc_sphere_optimizer_save_size(const obc_sphere_optimizer* solver) {
  return capi::save_size(solver);
}

obc_status obc_sphere_optimizer_save(const obc_sphere_optimizer* solver, void* blob, size_t capacity,
                                     obc_error* error) {
  return capi::save(solver, blob, capacity, error);
}

obc_status obc_sphere_optimizer_load(const void* blob, size_t size, const obc_host* host, obc_sphere_optimizer** out,
                                     obc_error* error) {
  return capi::load(blob, size, out, error, [&](std::span<const std::byte> bytes) {
    return std::make_unique<obc_sphere_optimizer>(host, so::Solver::shape_of(bytes), so::Solver::options_of(bytes),
                                                  std::span<const double>());
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
    const so::Options chosen = to_options(options);
    capi::require(chosen.hessian_products == 0,
                  "products of the Hessian need obc_sphere_optimizer_minimize_second_order or a run by _step");
    minimize(to_shape(count, dimension), chosen, f, nullptr, user, x, result, host);
  });
}

obc_status obc_sphere_optimizer_minimize_second_order(size_t count, size_t dimension,
                                                      const obc_sphere_optimizer_options* options,
                                                      obc_sphere_optimizer_function f,
                                                      obc_sphere_optimizer_product_function product, void* user,
                                                      double* x, obc_sphere_optimizer_result* result,
                                                      const obc_host* host, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(f != nullptr && product != nullptr && x != nullptr, "f, product or x is NULL");
    so::Options chosen = to_options(options);
    chosen.method = so::Method::truncated_newton;
    chosen.hessian_products = 1;
    minimize(to_shape(count, dimension), chosen, f, product, user, x, result, host);
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
    const capi::HostAdapter adapter(host);
    so::Relaxation relaxation({given.count, given.dimension}, to_options(options), adapter.host().memory);
    normalize_blocks(relaxation.shape(), x);
    so::Stop stop = so::Stop::cancelled;
    const auto report = [&] { copy_result(relaxation.result(), stop, result); };
    try {
      stop = run_relaxation(relaxation, neighbors_of(given), f, user, x, UINT64_MAX, adapter.host());
    } catch (const base::Error&) {
      report();
      throw;
    }
    report();
  });
}

obc_status obc_sphere_optimizer_relaxation_create(const obc_sphere_optimizer_blocks* blocks,
                                                  const obc_sphere_optimizer_relaxation_options* options,
                                                  const double* x0, const obc_host* host,
                                                  obc_sphere_optimizer_relaxation** out, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr && x0 != nullptr, "x0 or out is NULL");
    *out = nullptr;
    auto made = std::make_unique<obc_sphere_optimizer_relaxation>(host, checked_blocks(blocks), to_options(options));
    made->solver.start_at(x0);
    *out = made.release();
  });
}

obc_status obc_sphere_optimizer_relaxation_run(obc_sphere_optimizer_relaxation* relaxation,
                                               obc_sphere_optimizer_block_function f, void* user, uint64_t steps,
                                               obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(f != nullptr, "f is NULL");
    capi::checked(relaxation).solver.run(f, user, steps);
  });
}

obc_status obc_sphere_optimizer_relaxation_get_result(const obc_sphere_optimizer_relaxation* relaxation,
                                                      obc_sphere_optimizer_relaxation_result* result, double* x,
                                                      obc_error* error) {
  return capi::guarded(error, [&] {
    const OwnRelaxation& from = capi::checked(relaxation).solver;
    copy_result(from.result(), from.stop(), result);
    if (x != nullptr) std::copy(from.points().begin(), from.points().end(), x);
  });
}

size_t obc_sphere_optimizer_relaxation_save_size(const obc_sphere_optimizer_relaxation* relaxation) {
  return capi::save_size(relaxation);
}

obc_status obc_sphere_optimizer_relaxation_save(const obc_sphere_optimizer_relaxation* relaxation, void* blob,
                                                size_t capacity, obc_error* error) {
  return capi::save(relaxation, blob, capacity, error);
}

obc_status obc_sphere_optimizer_relaxation_load(const obc_sphere_optimizer_blocks* blocks, const void* blob,
                                                size_t size, const obc_host* host,
                                                obc_sphere_optimizer_relaxation** out, obc_error* error) {
  return capi::load(blob, size, out, error, [&](std::span<const std::byte>) {
    return std::make_unique<obc_sphere_optimizer_relaxation>(host, checked_blocks(blocks), so::RelaxationOptions{});
  });
}

void obc_sphere_optimizer_relaxation_destroy(obc_sphere_optimizer_relaxation* relaxation) {
  delete relaxation;
}

const char* obc_sphere_optimizer_stop_name(int32_t stop) {
  return so::stop_name(static_cast<so::Stop>(stop));
}

uint32_t obc_sphere_optimizer_version(void) {
  return base::version_number;
}
