// The projected gradient: feasible sets and options of any numbers, any results, projections, saved runs with changed
// bytes.
#include <algorithm>

#include "entries.h"
#include "orbicube/projected_gradient.h"

using namespace fuzz;

namespace {

// `saved` gets the run's bytes; without it the run comes from bytes that were changed, and its numbers may be any.
void run(obc_projected_gradient* solver, std::size_t n, std::size_t m, Input& in, std::vector<std::uint8_t>* saved) {
  const double centre = in.moderate();
  std::vector<double> x(n), gradient(n), multipliers(m);
  for (int i = 0; i < 60; ++i) {
    const double* at = nullptr;
    const std::int32_t request = obc_projected_gradient_step(solver, &at);
    require(request >= 0, "a step failed");
    if (request == OBC_PROJECTED_GRADIENT_DONE) break;
    if (request != OBC_PROJECTED_GRADIENT_NEED_FG) continue;
    if (saved != nullptr) require_finite({at, n}, "a point that is queried is not finite");
    double value = in.one_in(12) ? in.number() : 0;
    for (std::size_t j = 0; j < n; ++j) {
      value += (at[j] - centre) * (at[j] - centre);
      gradient[j] = in.one_in(20) ? in.number() : 2 * (at[j] - centre);
    }
    require(ok([&](obc_error* e) { return obc_projected_gradient_tell(solver, value, gradient.data(), e); }),
            "a value is refused");
  }
  obc_projected_gradient_result result;
  result.struct_size = sizeof result;
  require(ok([&](obc_error* e) { return obc_projected_gradient_get_result(solver, &result, x.data(), e); }),
          "no result");
  if (saved != nullptr) require_finite(x, "the best point is not finite");
  require(obc_projected_gradient_stop_name(result.stop) != nullptr, "a stop without a name");
  ok([&](obc_error* e) { return obc_projected_gradient_multipliers(solver, multipliers.data(), e); });
  ok([&](obc_error* e) { return obc_projected_gradient_certificate(solver, multipliers.data(), e); });
  if (saved == nullptr) return;
  saved->resize(obc_projected_gradient_save_size(solver));
  require(ok([&](obc_error* e) { return obc_projected_gradient_save(solver, saved->data(), saved->size(), e); }),
          "a run cannot be saved");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  const std::size_t n = in.below(6), m = in.below(4);
  const auto lower = in.numbers(n);
  auto upper = in.numbers(n);
  if (in.one_in(2)) {
    for (std::size_t i = 0; i < n; ++i)
      upper[i] = std::max(upper[i], lower[i]);
  }
  std::vector<std::size_t> starts = {0};
  for (std::size_t i = 0; i < m; ++i)
    starts.push_back(starts.back() + in.below(5));
  const auto columns = in.indices(starts.back(), n);
  const auto values = in.one_in(4) ? in.numbers(starts.back()) : in.moderates(starts.back());
  const auto b = in.one_in(4) ? in.numbers(m) : in.moderates(m);
  if (m > 1 && in.one_in(10)) starts[1] = starts[2] + in.byte();  // falls again, within the last start or not
  obc_projected_gradient_problem problem;
  obc_projected_gradient_problem_init(&problem, sizeof problem);
  problem.n = n;
  if (in.one_in(2)) problem.lower = lower.data();
  if (in.one_in(2)) problem.upper = upper.data();
  if (m > 0) {
    problem.m = m;
    problem.row_start = starts.data();
    problem.column = columns.data();
    problem.value = values.data();
    problem.b = b.data();
  }
  if (in.one_in(8)) {
    problem.project = [](const double* y, std::size_t count, double* x, void* user) -> std::int32_t {
      Input& from = *static_cast<Input*>(user);
      for (std::size_t i = 0; i < count; ++i)
        x[i] = from.one_in(30) ? from.number() : std::min(std::max(y[i], -1.0), 1.0);
      return from.one_in(30) ? 1 : 0;
    };
    problem.project_user = &in;
  }
  obc_projected_gradient_options options;
  obc_projected_gradient_options_init(&options, sizeof options);
  options.max_iterations = 50;
  if (in.one_in(2)) {
    options.method = in.choice(2);
    options.line_search = in.choice(2);
    options.memory = in.byte();
    options.history = in.byte();
    options.average_weight = in.number();
    options.gradient_tolerance = in.number();
    options.target = in.number();
    options.max_evaluations = in.byte();
  }
  const auto x0 = in.one_in(4) ? in.numbers(n) : in.moderates(n);
  std::vector<double> x(n), multipliers(m);
  ok([&](obc_error* e) {
    return obc_projected_gradient_project(&problem, x0.data(), x.data(), multipliers.data(), nullptr, host.c(), e);
  });
  obc_projected_gradient* solver = nullptr;
  if (!ok([&](obc_error* e) {
        return obc_projected_gradient_create(&problem, &options, x0.data(), host.c(), &solver, e);
      })) {
    require(solver == nullptr, "a handle beside an error");
    return 0;
  }
  std::vector<std::uint8_t> saved;
  run(solver, n, m, in, &saved);
  obc_projected_gradient_destroy(solver);
  for (std::size_t i = in.below(4); i > 0 && !saved.empty(); --i)
    saved[in.bits() % saved.size()] = in.byte();
  if (in.one_in(4)) saved.resize(in.bits() % (saved.size() + 1));
  obc_projected_gradient* loaded = nullptr;
  if (ok([&](obc_error* e) {
        return obc_projected_gradient_load(&problem, saved.data(), saved.size(), host.c(), &loaded, e);
      })) {
    run(loaded, n, m, in, nullptr);
    obc_projected_gradient_destroy(loaded);
  }
  return 0;
}
