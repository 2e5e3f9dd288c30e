// Minimizes without derivatives; wraps orbicube/trust_region.h.
//
//   std::vector<double> x = {0, 0};
//   auto result = orbicube::trust_region::minimize([](orbicube::Doubles x) { return x[0] * x[0] + x[1]; }, x, {{-1,
//   -1}, {1, 1}});
#ifndef ORBICUBE_TRUST_REGION_HPP
#define ORBICUBE_TRUST_REGION_HPP

#include <vector>

#include <orbicube/trust_region.h>
#include <orbicube/base.hpp>

namespace orbicube {
inline namespace api {
namespace trust_region {

using Options = detail::Filled<obc_trust_region_options, obc_trust_region_options_init>;
using Result = obc_trust_region_result;

// What is minimized, beside the function. Empty: none.
struct Problem {
  std::vector<double> lower, upper, scale, sign;
};

inline const char* stop_name(std::int32_t stop) {
  return obc_trust_region_stop_name(stop);
}

namespace detail {
using namespace orbicube::detail;

struct Filled : orbicube::detail::Filled<obc_trust_region_problem, obc_trust_region_problem_init> {
  Filled(const Problem& from, std::size_t unknowns, std::size_t residual_count) {
    n = unknowns;
    residuals = residual_count;
    lower = entries(from.lower, n, "lower");
    upper = entries(from.upper, n, "upper");
    scale = entries(from.scale, n, "scale");
    sign = entries(from.sign, residual_count, "sign");
  }
  static const double* entries(const std::vector<double>& from, std::size_t wanted, const char* what) {
    if (from.empty()) return nullptr;
    check_size(from.size(), wanted, what);
    return from.data();
  }
};

template <class F>
struct Function {
  F& f;
  std::size_t outputs;  // 0: f returns the value, else it fills the residuals
  Caught caught;

  static std::int32_t call(const double* x, std::size_t n, double* out, void* user) {
    Function& self = *static_cast<Function*>(user);
    return self.caught.guard([&]() -> std::int32_t {
      try {
        if constexpr (std::is_invocable_v<F&, Doubles, View<double>>)
          self.f(Doubles(x, n), View<double>(out, self.outputs));
        else
          *out = self.f(Doubles(x, n));
        return OBC_TRUST_REGION_CONTINUE;
      } catch (const EvaluationFailed&) {
        return OBC_TRUST_REGION_FAILED;
      } catch (const Stop& stop) {
        if (self.outputs == 0) *out = stop.value;
        return OBC_TRUST_REGION_STOP;
      }
    });
  }
};

template <class F>
Result minimize(F& f, View<double> x, std::size_t residuals, const Problem& problem, const Options& options,
                Host* host) {
  const Filled filled(problem, x.size(), residuals);
  Function<F> function{f, residuals, {}};
  Result result = sized<Result>();
  obc_error error;
  const obc_status status =
      obc_trust_region_minimize(&filled, &options, Function<F>::call, &function, x.data(), &result, c(host), &error);
  function.caught.rethrow();
  if (host != nullptr) host->rethrow();
  if (status != OBC_OK) throw Error(error);
  return result;
}
}  // namespace detail

// f(Doubles) returns the value; x is the start and receives the best point.
template <class F>
Result minimize(F&& f, View<double> x, const Problem& problem = {}, const Options& options = {}, Host* host = nullptr) {
  return detail::minimize(f, x, 0, problem, options, host);
}

// f(Doubles, View<double>) fills the residuals.
template <class F>
Result least_squares(F&& f, View<double> x, std::size_t residuals, const Problem& problem = {},
                     const Options& options = {}, Host* host = nullptr) {
  return detail::minimize(f, x, residuals, problem, options, host);
}

// A run by reverse communication:
//   while (solver.ask()) solver.tell(f(solver.point()));
// A host that it is given must outlive it; what the host's functions throw comes out of ask().
class Solver {
 public:
  Solver(Doubles x0, std::size_t residuals = 0, const Problem& problem = {}, const Options& options = {},
         Host* host = nullptr)
      : n_(x0.size()), outputs_(residuals == 0 ? 1 : residuals), host_(host) {
    const detail::Filled filled(problem, n_, residuals);
    obc_trust_region* out = nullptr;
    detail::call(host, [&](obc_error* error) {
      return obc_trust_region_create(&filled, &options, x0.data(), detail::c(host), &out, error);
    });
    handle_.reset(out);
  }
  // Goes on with a run that was saved, of the same problem.
  static Solver load(const std::vector<unsigned char>& bytes, std::size_t unknowns, std::size_t residuals = 0,
                     const Problem& problem = {}, Host* host = nullptr) {
    Solver solver(unknowns, residuals == 0 ? 1 : residuals, host);
    const detail::Filled filled(problem, unknowns, residuals);
    obc_trust_region* out = nullptr;
    detail::call(host, [&](obc_error* error) {
      return obc_trust_region_load(&filled, bytes.data(), bytes.size(), detail::c(host), &out, error);
    });
    solver.handle_.reset(out);
    return solver;
  }

  // Goes on to the next question; false when the run has ended.
  bool ask() {
    for (;;) {
      const std::int32_t request = obc_trust_region_step(handle_.get(), &points_, &count_);
      if (host_ != nullptr) host_->rethrow();
      if (request < 0) throw Error(request, "trust_region: step");
      if (request != OBC_TRUST_REGION_ITERATION) return request == OBC_TRUST_REGION_NEED_VALUES;
    }
  }
  Doubles point(std::size_t i = 0) const {
    return {points_ + i * n_, n_};
  }                                                   // of the queried ones, until the next call of ask()
  std::size_t point_count() const { return count_; }  // they may be evaluated at the same time
  // The value, or the residuals, at the first of them; NaN: there is none.
  void tell(double value) { tell(Doubles(&value, 1)); }
  void tell(Doubles outputs) {
    detail::check_size(outputs.size(), outputs_, "outputs");
    detail::call(nullptr,
                 [&](obc_error* error) { return obc_trust_region_tell(handle_.get(), outputs.data(), error); });
  }
  // Evaluations made before: rows of points with their outputs; before the first call of ask().
  void give(Doubles points, Doubles outputs) {
    const std::size_t count = detail::rows(points.size(), n_, "points");
    detail::check_size(outputs.size(), count * outputs_, "outputs");
    detail::call(nullptr, [&](obc_error* error) {
      return obc_trust_region_give(handle_.get(), points.data(), outputs.data(), count, error);
    });
  }
  Result result() const {
    Result result = detail::sized<Result>();
    detail::call(nullptr, [&](obc_error* error) {
      return obc_trust_region_get_result(handle_.get(), &result, nullptr, nullptr, error);
    });
    return result;
  }
  std::vector<double> best() const {
    std::vector<double> x(n_);
    detail::call(nullptr, [&](obc_error* error) {
      return obc_trust_region_get_result(handle_.get(), nullptr, x.data(), nullptr, error);
    });
    return x;
  }
  std::vector<unsigned char> save() const {
    std::vector<unsigned char> bytes(obc_trust_region_save_size(handle_.get()));
    detail::call(nullptr, [&](obc_error* error) {
      return obc_trust_region_save(handle_.get(), bytes.data(), bytes.size(), error);
    });
    return bytes;
  }
  obc_trust_region* handle() const noexcept { return handle_.get(); }

 private:
  Solver(std::size_t n, std::size_t outputs, Host* host) : n_(n), outputs_(outputs), host_(host) {}

  std::size_t n_, outputs_, count_ = 0;
  Host* host_;
  const double* points_ = nullptr;
  detail::Handle<obc_trust_region, obc_trust_region_destroy> handle_;
};

}  // namespace trust_region
}  // namespace api
}  // namespace orbicube

#endif
