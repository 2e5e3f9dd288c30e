// Minimizes over products of unit spheres; wraps orbicube/sphere_optimizer.h.
//
//   auto result = orbicube::sphere_optimizer::minimize(f, x, 3);   // f(Doubles x, View<double> gradient) -> value
#ifndef ORBICUBE_SPHERE_OPTIMIZER_HPP
#define ORBICUBE_SPHERE_OPTIMIZER_HPP

#include <vector>

#include <orbicube/sphere_optimizer.h>
#include <orbicube/base.hpp>

namespace orbicube {
inline namespace api {
namespace sphere_optimizer {

using Options = detail::Filled<obc_sphere_optimizer_options, obc_sphere_optimizer_options_init>;
using Result = obc_sphere_optimizer_result;
using RelaxationOptions =
    detail::Filled<obc_sphere_optimizer_relaxation_options, obc_sphere_optimizer_relaxation_options_init>;
using RelaxationResult = obc_sphere_optimizer_relaxation_result;

inline const char* stop_name(std::int32_t stop) {
  return obc_sphere_optimizer_stop_name(stop);
}

namespace detail {
using namespace orbicube::detail;

template <class F>
struct Function {
  F& f;
  Caught caught;

  template <class Call>
  std::int32_t guarded(double* value, Call&& call) {
    return caught.guard([&]() -> std::int32_t {
      try {
        call();
        return OBC_SPHERE_OPTIMIZER_CONTINUE;
      } catch (const EvaluationFailed&) {
        return OBC_SPHERE_OPTIMIZER_FAILED;
      } catch (const Stop& stop) {
        *value = stop.value;
        return OBC_SPHERE_OPTIMIZER_STOP;
      }
    });
  }
  static std::int32_t all(const double* x, std::size_t count, std::size_t dimension, double* value, double* gradient,
                          void* user) {
    Function& self = *static_cast<Function*>(user);
    const std::size_t n = count * dimension;
    return self.guarded(value, [&] { *value = self.f(Doubles(x, n), View<double>(gradient, n)); });
  }
  static std::int32_t one(std::size_t block, const double* place, const double* points, double* value, double* gradient,
                          double* hessian, void* user) {
    Function& self = *static_cast<Function*>(user);
    return self.guarded(value, [&] { *value = self.f(block, place, points, gradient, hessian); });
  }
};

template <class F, class P>
struct FunctionAndProduct : Function<F> {
  P& product;

  FunctionAndProduct(F& evaluate, P& multiply) : Function<F>{evaluate, {}}, product(multiply) {}
  static std::int32_t value(const double* x, std::size_t count, std::size_t dimension, double* value, double* gradient,
                            void* user) {
    return Function<F>::all(x, count, dimension, value, gradient, static_cast<Function<F>*>(self_of(user)));
  }
  static std::int32_t multiply(const double* x, const double* direction, std::size_t count, std::size_t dimension,
                               double* out, void* user) {
    FunctionAndProduct& self = *self_of(user);
    const std::size_t n = count * dimension;
    double unused;
    return self.guarded(&unused, [&] { self.product(Doubles(x, n), Doubles(direction, n), View<double>(out, n)); });
  }

 private:
  static FunctionAndProduct* self_of(void* user) { return static_cast<FunctionAndProduct*>(user); }
};

// obc_sphere_optimizer_blocks and the arrays that it points at.
class Blocks {
 public:
  Blocks(std::uint32_t dimension, const std::vector<std::vector<std::uint32_t>>& neighbors) : start_{0} {
    for (const std::vector<std::uint32_t>& row : neighbors) {
      all_.insert(all_.end(), row.begin(), row.end());
      start_.push_back(all_.size());
    }
    blocks_.dimension = dimension;
    blocks_.count = neighbors.size();
    blocks_.neighbor_start = start_.data();
    blocks_.neighbor = all_.data();
  }
  Blocks(const Blocks&) = delete;
  Blocks& operator=(const Blocks&) = delete;
  const obc_sphere_optimizer_blocks* c() const { return &blocks_; }

 private:
  std::vector<std::size_t> start_;
  std::vector<std::uint32_t> all_;
  Filled<obc_sphere_optimizer_blocks, obc_sphere_optimizer_blocks_init> blocks_;
};
}  // namespace detail

// f(Doubles x, View<double> gradient) fills the gradient and returns the value; x, blocks of `dimension` numbers, is
// the start and receives the best point.
template <class F>
Result minimize(F&& f, View<double> x, std::size_t dimension, const Options& options = {}, Host* host = nullptr) {
  using Called = detail::Function<std::remove_reference_t<F>>;
  const std::size_t count = detail::rows(x.size(), dimension == 0 ? 1 : dimension, "x");
  Called function{f, {}};
  Result result = detail::sized<Result>();
  obc_error error;
  const obc_status status = obc_sphere_optimizer_minimize(count, dimension, &options, Called::all, &function, x.data(),
                                                          &result, detail::c(host), &error);
  function.caught.rethrow();
  if (host != nullptr) host->rethrow();
  if (status != OBC_OK) throw Error(error);
  return result;
}

// The same with TRUNCATED_NEWTON. product(Doubles x, Doubles direction, View<double> out) fills the product of the
// Hessian of f at x, as a function of all numbers of x, and a direction.
template <class F, class P>
Result minimize_second_order(F&& f, P&& product, View<double> x, std::size_t dimension, const Options& options = {},
                             Host* host = nullptr) {
  using Called = detail::FunctionAndProduct<std::remove_reference_t<F>, std::remove_reference_t<P>>;
  const std::size_t count = detail::rows(x.size(), dimension == 0 ? 1 : dimension, "x");
  Called function(f, product);
  Result result = detail::sized<Result>();
  obc_error error;
  const obc_status status =
      obc_sphere_optimizer_minimize_second_order(count, dimension, &options, Called::value, Called::multiply, &function,
                                                 x.data(), &result, detail::c(host), &error);
  function.caught.rethrow();
  if (host != nullptr) host->rethrow();
  if (status != OBC_OK) throw Error(error);
  return result;
}

// Block by block. f(block, place, points, gradient, hessian), pointers as in obc_sphere_optimizer_block_function, fills
// what is not NULL and returns the value. `neighbors[i]`: the blocks whose part of f contains block i.
template <class F>
RelaxationResult relax(F&& f, View<double> x, std::uint32_t dimension,
                       const std::vector<std::vector<std::uint32_t>>& neighbors, const RelaxationOptions& options = {},
                       Host* host = nullptr) {
  using Called = detail::Function<std::remove_reference_t<F>>;
  detail::check_size(x.size(), neighbors.size() * dimension, "x");
  const detail::Blocks blocks(dimension, neighbors);
  Called function{f, {}};
  RelaxationResult result = detail::sized<RelaxationResult>();
  obc_error error;
  const obc_status status = obc_sphere_optimizer_relax(blocks.c(), &options, Called::one, &function, x.data(), &result,
                                                       detail::c(host), &error);
  function.caught.rethrow();
  if (host != nullptr) host->rethrow();
  if (status != OBC_OK) throw Error(error);
  return result;
}

// The same in parts; ends in the same bits. A host that it is given must outlive it.
class Relaxation {
 public:
  Relaxation(Doubles x0, std::uint32_t dimension, const std::vector<std::vector<std::uint32_t>>& neighbors,
             const RelaxationOptions& options = {}, Host* host = nullptr)
      : n_(x0.size()), host_(host) {
    detail::check_size(n_, neighbors.size() * dimension, "x0");
    const detail::Blocks blocks(dimension, neighbors);
    obc_sphere_optimizer_relaxation* out = nullptr;
    detail::call(host, [&](obc_error* error) {
      return obc_sphere_optimizer_relaxation_create(blocks.c(), &options, x0.data(), detail::c(host), &out, error);
    });
    handle_.reset(out);
  }
  // Goes on with one that was saved, of the same neighbors.
  static Relaxation load(const std::vector<unsigned char>& bytes, std::uint32_t dimension,
                         const std::vector<std::vector<std::uint32_t>>& neighbors, Host* host = nullptr) {
    Relaxation relaxation;
    relaxation.n_ = neighbors.size() * dimension;
    relaxation.host_ = host;
    const detail::Blocks blocks(dimension, neighbors);
    obc_sphere_optimizer_relaxation* out = nullptr;
    detail::call(host, [&](obc_error* error) {
      return obc_sphere_optimizer_relaxation_load(blocks.c(), bytes.data(), bytes.size(), detail::c(host), &out, error);
    });
    relaxation.handle_.reset(out);
    return relaxation;
  }

  // Relaxes up to the given number of further blocks, with f as of relax. The result's stop is RUNNING when there is
  // more to do. Whatever breaks it off, the next call goes on as if it had not been.
  template <class F>
  RelaxationResult run(F&& f, std::uint64_t steps) {
    using Called = detail::Function<std::remove_reference_t<F>>;
    Called function{f, {}};
    obc_error error;
    const obc_status status = obc_sphere_optimizer_relaxation_run(handle_.get(), Called::one, &function, steps, &error);
    function.caught.rethrow();
    if (host_ != nullptr) host_->rethrow();
    if (status != OBC_OK) throw Error(error);
    return result();
  }
  RelaxationResult result() const {
    RelaxationResult result = detail::sized<RelaxationResult>();
    detail::call(nullptr, [&](obc_error* error) {
      return obc_sphere_optimizer_relaxation_get_result(handle_.get(), &result, nullptr, error);
    });
    return result;
  }
  std::vector<double> points() const {
    std::vector<double> x(n_);
    detail::call(nullptr, [&](obc_error* error) {
      return obc_sphere_optimizer_relaxation_get_result(handle_.get(), nullptr, x.data(), error);
    });
    return x;
  }
  std::vector<unsigned char> save() const {
    std::vector<unsigned char> bytes(obc_sphere_optimizer_relaxation_save_size(handle_.get()));
    detail::call(nullptr, [&](obc_error* error) {
      return obc_sphere_optimizer_relaxation_save(handle_.get(), bytes.data(), bytes.size(), error);
    });
    return bytes;
  }
  obc_sphere_optimizer_relaxation* handle() const noexcept { return handle_.get(); }

 private:
  Relaxation() = default;

  std::size_t n_ = 0;
  Host* host_ = nullptr;
  detail::Handle<obc_sphere_optimizer_relaxation, obc_sphere_optimizer_relaxation_destroy> handle_;
};

// A run by reverse communication:
//   while (solver.ask()) solver.tell(value, gradient);   // at solver.point()
// With the option hessian_products, where solver.direction() is not empty, reply with tell_product(product).
// A host that it is given must outlive it; what the host's functions throw comes out of ask().
class Solver {
 public:
  Solver(Doubles x0, std::size_t dimension, const Options& options = {}, Host* host = nullptr)
      : n_(x0.size()), host_(host) {
    const std::size_t count = detail::rows(n_, dimension == 0 ? 1 : dimension, "x0");
    obc_sphere_optimizer* out = nullptr;
    detail::call(host, [&](obc_error* error) {
      return obc_sphere_optimizer_create(count, dimension, &options, x0.data(), detail::c(host), &out, error);
    });
    handle_.reset(out);
  }
  // Goes on with a run that was saved.
  static Solver load(const std::vector<unsigned char>& bytes, Host* host = nullptr) {
    Solver solver;
    solver.host_ = host;
    obc_sphere_optimizer* out = nullptr;
    detail::call(host, [&](obc_error* error) {
      return obc_sphere_optimizer_load(bytes.data(), bytes.size(), detail::c(host), &out, error);
    });
    solver.handle_.reset(out);
    std::size_t count = 0, dimension = 0;
    detail::call(nullptr,
                 [&](obc_error* error) { return obc_sphere_optimizer_get_shape(out, &count, &dimension, error); });
    solver.n_ = count * dimension;
    return solver;
  }

  // Goes on to the next question; false when the run has ended.
  bool ask() {
    for (;;) {
      const std::int32_t request = obc_sphere_optimizer_step(handle_.get(), &point_);
      if (host_ != nullptr) host_->rethrow();
      if (request < 0) throw Error(request, "sphere_optimizer: step");
      if (request != OBC_SPHERE_OPTIMIZER_ITERATION) return request != OBC_SPHERE_OPTIMIZER_DONE;
    }
  }
  Doubles point() const { return {point_, n_}; }  // the queried point, until the next call of ask()
  // The vector whose product with the Hessian there is queried; empty where value and gradient are.
  Doubles direction() const {
    const double* direction = nullptr;
    const bool asked = obc_sphere_optimizer_get_direction(handle_.get(), &direction, nullptr) == OBC_OK;
    return {direction, asked ? n_ : 0};
  }
  // That product; an entry of NaN: there is none.
  void tell_product(Doubles product) {
    detail::check_size(product.size(), n_, "product");
    detail::call(nullptr, [&](obc_error* error) {
      return obc_sphere_optimizer_tell_product(handle_.get(), product.data(), error);
    });
  }
  // Value and gradient there; NaN: there is none.
  void tell(double value, Doubles gradient) {
    detail::check_size(gradient.size(), n_, "gradient");
    detail::call(nullptr, [&](obc_error* error) {
      return obc_sphere_optimizer_tell(handle_.get(), value, gradient.data(), error);
    });
  }
  Result result() const {
    Result result = detail::sized<Result>();
    detail::call(nullptr, [&](obc_error* error) {
      return obc_sphere_optimizer_get_result(handle_.get(), &result, nullptr, error);
    });
    return result;
  }
  std::vector<double> best() const {
    std::vector<double> x(n_);
    detail::call(nullptr, [&](obc_error* error) {
      return obc_sphere_optimizer_get_result(handle_.get(), nullptr, x.data(), error);
    });
    return x;
  }
  std::vector<unsigned char> save() const {
    std::vector<unsigned char> bytes(obc_sphere_optimizer_save_size(handle_.get()));
    detail::call(nullptr, [&](obc_error* error) {
      return obc_sphere_optimizer_save(handle_.get(), bytes.data(), bytes.size(), error);
    });
    return bytes;
  }
  obc_sphere_optimizer* handle() const noexcept { return handle_.get(); }

 private:
  Solver() = default;

  std::size_t n_ = 0;
  Host* host_ = nullptr;
  const double* point_ = nullptr;
  detail::Handle<obc_sphere_optimizer, obc_sphere_optimizer_destroy> handle_;
};

}  // namespace sphere_optimizer
}  // namespace api
}  // namespace orbicube

#endif
