// Minimizes with gradients under bounds and linear equations, and projects; wraps orbicube/projected_gradient.h.
//
//   orbicube::projected_gradient::Problem problem;
//   problem.lower.assign(5, 0.0);
//   problem.rows.add({{0, 1.0}, {3, 2.0}}, 1.0);       // x0 + 2 x3 = 1
//   auto result = orbicube::projected_gradient::minimize(f, x, problem);   // f(Doubles x, View<double> gradient) ->
//   value
#ifndef ORBICUBE_PROJECTED_GRADIENT_HPP
#define ORBICUBE_PROJECTED_GRADIENT_HPP

#include <initializer_list>
#include <vector>

#include <orbicube/projected_gradient.h>
#include <orbicube/base.hpp>

namespace orbicube {
inline namespace api {
namespace projected_gradient {

using Options = detail::Filled<obc_projected_gradient_options, obc_projected_gradient_options_init>;
using Result = obc_projected_gradient_result;

// A x = b, row by row.
struct Rows {
  std::vector<std::size_t> row_start = {0};
  std::vector<std::uint32_t> column;
  std::vector<double> value, b;

  void add(std::initializer_list<std::pair<std::uint32_t, double>> entries, double right) {
    for (const auto& [where, what] : entries) {
      column.push_back(where);
      value.push_back(what);
    }
    row_start.push_back(column.size());
    b.push_back(right);
  }
};

// The feasible set: bounds (empty: none) and rows, or a projection onto a convex set: project(y, x) fills x.
struct Problem {
  std::vector<double> lower, upper;
  Rows rows;
  std::function<void(Doubles, View<double>)> project;
};

inline const char* stop_name(std::int32_t stop) {
  return obc_projected_gradient_stop_name(stop);
}

namespace detail {
using namespace orbicube::detail;

// The C struct; it must outlive the solver where there is a projection, and does not move.
struct Filled : orbicube::detail::Filled<obc_projected_gradient_problem, obc_projected_gradient_problem_init> {
  std::function<void(Doubles, View<double>)> function;
  Caught caught;

  Filled(const Problem& from, std::size_t unknowns) : function(from.project) {
    n = unknowns;
    if (!from.lower.empty()) check_size(from.lower.size(), n, "lower");
    if (!from.upper.empty()) check_size(from.upper.size(), n, "upper");
    lower = from.lower.empty() ? nullptr : from.lower.data();
    upper = from.upper.empty() ? nullptr : from.upper.data();
    m = from.rows.b.size();
    check_size(from.rows.row_start.size(), m + 1, "row_start");
    check_size(from.rows.column.size(), from.rows.row_start.back(), "column");
    check_size(from.rows.value.size(), from.rows.row_start.back(), "value");
    if (m > 0) {
      row_start = from.rows.row_start.data();
      column = from.rows.column.data();
      value = from.rows.value.data();
      b = from.rows.b.data();
    }
    if (function) {
      project = projected;
      project_user = this;
    }
  }
  Filled(const Filled&) = delete;
  Filled& operator=(const Filled&) = delete;

  static std::int32_t projected(const double* y, std::size_t n, double* x, void* user) {
    Filled& self = *static_cast<Filled*>(user);
    return self.caught.guard([&] {
      self.function(Doubles(y, n), View<double>(x, n));
      return 0;
    });
  }
};

template <class F>
struct Function {
  F& f;
  Caught caught;

  static std::int32_t call(const double* x, std::size_t n, double* value, double* gradient, void* user) {
    Function& self = *static_cast<Function*>(user);
    return self.caught.guard([&]() -> std::int32_t {
      try {
        *value = self.f(Doubles(x, n), View<double>(gradient, n));
        return OBC_PROJECTED_GRADIENT_CONTINUE;
      } catch (const EvaluationFailed&) {
        return OBC_PROJECTED_GRADIENT_FAILED;
      } catch (const Stop& stop) {
        *value = stop.value;
        return OBC_PROJECTED_GRADIENT_STOP;
      }
    });
  }
};
}  // namespace detail

// f(Doubles x, View<double> gradient) fills the gradient and returns the value; x is the start and receives the best
// point.
template <class F>
Result minimize(F&& f, View<double> x, const Problem& problem = {}, const Options& options = {}, Host* host = nullptr) {
  detail::Filled filled(problem, x.size());
  detail::Function<std::remove_reference_t<F>> function{f, {}};
  Result result = detail::sized<Result>();
  obc_error error;
  const obc_status status =
      obc_projected_gradient_minimize(&filled, &options, detail::Function<std::remove_reference_t<F>>::call, &function,
                                      x.data(), &result, detail::c(host), &error);
  function.caught.rethrow();
  filled.caught.rethrow();
  if (host != nullptr) host->rethrow();
  if (status != OBC_OK) throw Error(error);
  return result;
}

// x becomes the point of the feasible set that is nearest to y; returns the multipliers of the rows.
inline std::vector<double> project(Doubles y, View<double> x, const Problem& problem, Result* result = nullptr,
                                   Host* host = nullptr) {
  orbicube::detail::check_size(x.size(), y.size(), "x");
  detail::Filled filled(problem, y.size());
  std::vector<double> multipliers(filled.m);
  Result found = detail::sized<Result>();
  detail::call(host, [&](obc_error* error) {
    return obc_projected_gradient_project(&filled, y.data(), x.data(), multipliers.data(), &found, detail::c(host),
                                          error);
  });
  if (result != nullptr) *result = found;
  return multipliers;
}

// A run by reverse communication:
//   while (solver.ask()) solver.tell(value, gradient);   // at solver.point()
// A host that it is given must outlive it; what the host's functions throw comes out of ask().
class Solver {
 public:
  Solver(Doubles x0, const Problem& problem = {}, const Options& options = {}, Host* host = nullptr)
      : problem_(std::make_unique<detail::Filled>(problem, x0.size())), host_(host) {
    obc_projected_gradient* out = nullptr;
    const obc_projected_gradient_problem& filled = *problem_;
    call(host, [&](obc_error* error) {
      return obc_projected_gradient_create(&filled, &options, x0.data(), detail::c(host), &out, error);
    });
    handle_.reset(out);
  }
  // Goes on with a run that was saved, of the same problem.
  static Solver load(const std::vector<unsigned char>& bytes, std::size_t unknowns, const Problem& problem = {},
                     Host* host = nullptr) {
    Solver solver(std::make_unique<detail::Filled>(problem, unknowns), host);
    obc_projected_gradient* out = nullptr;
    const obc_projected_gradient_problem& filled = *solver.problem_;
    solver.call(host, [&](obc_error* error) {
      return obc_projected_gradient_load(&filled, bytes.data(), bytes.size(), detail::c(host), &out, error);
    });
    solver.handle_.reset(out);
    return solver;
  }

  // Goes on to the next question; false when the run has ended.
  bool ask() {
    for (;;) {
      const std::int32_t request = obc_projected_gradient_step(handle_.get(), &point_);
      problem_->caught.rethrow();
      if (host_ != nullptr) host_->rethrow();
      if (request < 0) throw Error(request, "projected_gradient: step");
      if (request != OBC_PROJECTED_GRADIENT_ITERATION) return request == OBC_PROJECTED_GRADIENT_NEED_FG;
    }
  }
  Doubles point() const { return {point_, problem_->n}; }  // the queried point, until the next call of ask()
  // Value and gradient there; NaN: there is none.
  void tell(double value, Doubles gradient) {
    detail::check_size(gradient.size(), problem_->n, "gradient");
    call(nullptr,
         [&](obc_error* error) { return obc_projected_gradient_tell(handle_.get(), value, gradient.data(), error); });
  }
  Result result() const {
    Result result = detail::sized<Result>();
    detail::call(nullptr, [&](obc_error* error) {
      return obc_projected_gradient_get_result(handle_.get(), &result, nullptr, error);
    });
    return result;
  }
  std::vector<double> best() const {
    std::vector<double> x(problem_->n);
    detail::call(nullptr, [&](obc_error* error) {
      return obc_projected_gradient_get_result(handle_.get(), nullptr, x.data(), error);
    });
    return x;
  }
  std::vector<double> multipliers() const {
    std::vector<double> t(problem_->m);
    detail::call(nullptr,
                 [&](obc_error* error) { return obc_projected_gradient_multipliers(handle_.get(), t.data(), error); });
    return t;
  }
  std::vector<double> certificate() const {
    std::vector<double> c(problem_->m);
    detail::call(nullptr,
                 [&](obc_error* error) { return obc_projected_gradient_certificate(handle_.get(), c.data(), error); });
    return c;
  }
  std::vector<unsigned char> save() const {
    std::vector<unsigned char> bytes(obc_projected_gradient_save_size(handle_.get()));
    detail::call(nullptr, [&](obc_error* error) {
      return obc_projected_gradient_save(handle_.get(), bytes.data(), bytes.size(), error);
    });
    return bytes;
  }
  obc_projected_gradient* handle() const noexcept { return handle_.get(); }

 private:
  Solver(std::unique_ptr<detail::Filled> problem, Host* host) : problem_(std::move(problem)), host_(host) {}
  template <class F>
  void call(Host* host, F&& f) {
    obc_error error;
    const obc_status status = f(&error);
    problem_->caught.rethrow();
    if (host != nullptr) host->rethrow();
    if (status != OBC_OK) throw Error(error);
  }

  std::unique_ptr<detail::Filled> problem_;
  Host* host_;
  detail::Handle<obc_projected_gradient, obc_projected_gradient_destroy> handle_;
  const double* point_ = nullptr;
};

}  // namespace projected_gradient
}  // namespace api
}  // namespace orbicube

#endif
