// The trust region: problems and options of any numbers, any results, and saved runs with changed bytes.
#include <algorithm>

#include "entries.h"
#include "orbicube/trust_region.h"

using namespace fuzz;

namespace {

// `saved` gets the run's bytes; without it the run comes from bytes that were changed, and its numbers may be any.
void run(obc_trust_region* solver, std::size_t n, std::size_t outputs, Input& in, std::vector<std::uint8_t>* saved) {
  const double centre = in.moderate();
  std::vector<double> x(n);
  for (int i = 0; i < 60; ++i) {
    const double* points = nullptr;
    std::size_t count = 0;
    const std::int32_t request = obc_trust_region_step(solver, &points, &count);
    require(request >= 0, "a step failed");
    if (request == OBC_TRUST_REGION_DONE) break;
    if (request != OBC_TRUST_REGION_NEED_VALUES) continue;
    require(count > 0, "no points are queried");
    if (saved != nullptr) require_finite({points, n * count}, "a point that is queried is not finite");
    std::vector<double> answer(outputs);
    for (std::size_t k = 0; k < outputs; ++k) {
      answer[k] = in.one_in(9) ? in.number() : 0;
      for (std::size_t j = 0; j < n; ++j)
        answer[k] += (points[j] - centre) * (points[j] - centre) * double(k + 1) + 0.1 * points[j];
    }
    require(ok([&](obc_error* e) { return obc_trust_region_tell(solver, in.one_in(20) ? nullptr : answer.data(), e); }),
            "a value for a request is refused");
  }
  obc_trust_region_result result;
  result.struct_size = sizeof result;
  std::vector<double> best(outputs);
  require(ok([&](obc_error* e) { return obc_trust_region_get_result(solver, &result, x.data(), best.data(), e); }),
          "no result");
  if (saved != nullptr) require_finite(x, "the best point is not finite");
  require(obc_trust_region_stop_name(result.stop) != nullptr, "a stop without a name");
  if (saved == nullptr) return;
  saved->resize(obc_trust_region_save_size(solver));
  require(ok([&](obc_error* e) { return obc_trust_region_save(solver, saved->data(), saved->size(), e); }),
          "a run cannot be saved");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  const std::size_t n = in.below(5), m = in.one_in(3) ? 1 + in.below(4) : 0;
  const auto lower = in.numbers(n), scale = in.numbers(n), sign = in.numbers(m);
  auto upper = in.numbers(n), x0 = in.one_in(4) ? in.numbers(n) : in.moderates(n);
  if (in.one_in(2)) {
    for (std::size_t i = 0; i < n; ++i)
      upper[i] = std::max(upper[i], lower[i]);
  }
  obc_trust_region_problem problem;
  obc_trust_region_problem_init(&problem, sizeof problem);
  problem.n = in.one_in(40) ? in.bits() : n;
  if (in.one_in(3)) problem.objective = static_cast<std::int32_t>(in.below(5));
  problem.residuals = in.one_in(40) ? in.bits() : m;
  const bool whole = problem.n == n && problem.residuals == m;
  if (!whole) {  // sizes that no memory has: refused before an array is read
    if (problem.n < 1u << 24 && problem.residuals < 1u << 24) return 0;
  }
  if (whole && in.one_in(2)) problem.lower = lower.data();
  if (whole && in.one_in(2)) problem.upper = upper.data();
  if (whole && in.one_in(4)) problem.scale = scale.data();
  if (whole && in.one_in(4)) problem.sign = sign.data();
  obc_trust_region_options options;
  obc_trust_region_options_init(&options, sizeof options);
  if (in.one_in(2)) {
    options.method = in.choice(2);
    options.start = in.choice(3);
    options.points = in.byte();
    options.radius_begin = in.one_in(2) ? in.number() : 0;
    options.radius_end = in.one_in(2) ? in.number() : 1e-6;
    options.target = in.number();
    options.noise_absolute = in.one_in(3) ? in.number() : 0;
    options.noise_relative = in.one_in(3) ? in.number() : 0;
    options.restarts = in.below(3);
    options.max_evaluations = in.byte();
  }
  if (!whole) return 0;
  obc_trust_region* solver = nullptr;
  if (!ok([&](obc_error* e) { return obc_trust_region_create(&problem, &options, x0.data(), host.c(), &solver, e); })) {
    require(solver == nullptr, "a handle beside an error");
    return 0;
  }
  const std::size_t outputs = std::max<std::size_t>(m, 1);
  if (in.one_in(3)) {
    const auto points = in.moderates(2 * n), values = in.numbers(2 * outputs);
    ok([&](obc_error* e) { return obc_trust_region_give(solver, points.data(), values.data(), 2, e); });
  }
  std::vector<std::uint8_t> saved;
  run(solver, n, outputs, in, &saved);
  obc_trust_region_destroy(solver);

  // The run from its bytes, with some of them changed or cut off.
  for (std::size_t i = in.below(4); i > 0 && !saved.empty(); --i)
    saved[in.bits() % saved.size()] = in.byte();
  if (in.one_in(4)) saved.resize(in.bits() % (saved.size() + 1));
  obc_trust_region* loaded = nullptr;
  if (ok([&](obc_error* e) {
        return obc_trust_region_load(&problem, saved.data(), saved.size(), host.c(), &loaded, e);
      })) {
    run(loaded, n, outputs, in, nullptr);
    obc_trust_region_destroy(loaded);
  }
  const auto rest = in.rest();
  if (ok([&](obc_error* e) { return obc_trust_region_load(&problem, rest.data(), rest.size(), host.c(), &loaded, e); }))
    obc_trust_region_destroy(loaded);
  return 0;
}
