// The sphere optimizer, all at once and block by block: any numbers and replies, and saved runs with changed bytes.
#include "orbicube/sphere_optimizer.h"
#include "entries.h"

using namespace fuzz;

namespace {

// `saved` gets the run's bytes; without it the run comes from bytes that were changed, and its numbers may be any.
void run(obc_sphere_optimizer* solver, Input& in, std::vector<std::uint8_t>* saved) {
  std::size_t count = 0, dimension = 0;
  require(ok([&](obc_error* e) { return obc_sphere_optimizer_get_shape(solver, &count, &dimension, e); }), "no shape");
  const std::size_t n = count * dimension;
  std::vector<double> x(n), gradient(n);
  for (int i = 0; i < 40; ++i) {
    const double* at = nullptr;
    const std::int32_t request = obc_sphere_optimizer_step(solver, &at);
    require(request >= 0, "a step failed");
    if (request == OBC_SPHERE_OPTIMIZER_DONE) break;
    if (request != OBC_SPHERE_OPTIMIZER_NEED_FG) continue;
    if (saved != nullptr) require_finite({at, n}, "a point that is queried is not finite");
    double value = in.one_in(12) ? in.number() : 0;
    for (std::size_t j = 0; j < n; ++j) {
      value += at[j] * at[j] * double(j + 1);
      gradient[j] = in.one_in(20) ? in.number() : 2 * at[j] * double(j + 1);
    }
    require(ok([&](obc_error* e) { return obc_sphere_optimizer_tell(solver, value, gradient.data(), e); }),
            "a value is refused");
  }
  obc_sphere_optimizer_result result;
  result.struct_size = sizeof result;
  require(ok([&](obc_error* e) { return obc_sphere_optimizer_get_result(solver, &result, x.data(), e); }), "no result");
  if (saved != nullptr) require_finite(x, "the best point is not finite");
  if (saved == nullptr) return;
  saved->resize(obc_sphere_optimizer_save_size(solver));
  require(ok([&](obc_error* e) { return obc_sphere_optimizer_save(solver, saved->data(), saved->size(), e); }),
          "a run cannot be saved");
}

void change(std::vector<std::uint8_t>& saved, Input& in) {
  for (std::size_t i = in.below(4); i > 0 && !saved.empty(); --i)
    saved[in.bits() % saved.size()] = in.byte();
  if (in.one_in(4)) saved.resize(in.bits() % (saved.size() + 1));
}

struct Part {
  Input* in;
  std::size_t dimension;
};
std::int32_t part(std::size_t, const double* place, const double*, double* value, double* gradient, double* hessian,
                  void* user) {
  const Part& of = *static_cast<const Part*>(user);
  *value = of.in->one_in(30) ? of.in->number() : 0;
  for (std::size_t j = 0; j < of.dimension; ++j) {
    *value += place[j] * double(j);
    if (gradient != nullptr) gradient[j] = of.in->one_in(40) ? of.in->number() : double(j);
    for (std::size_t k = 0; hessian != nullptr && k < of.dimension; ++k)
      hessian[j * of.dimension + k] = of.in->one_in(60) ? of.in->number() : 0;
  }
  return of.in->one_in(60) ? of.in->choice(3) : 0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  const std::size_t count = in.below(6), dimension = in.below(7);
  const auto x0 = in.one_in(4) ? in.numbers(count * dimension) : in.moderates(count * dimension);
  obc_sphere_optimizer_options options;
  obc_sphere_optimizer_options_init(&options, sizeof options);
  if (in.one_in(2)) {
    options.method = in.choice(3);
    options.memory = in.byte();
    options.history = in.byte();
    options.gradient_tolerance = in.number();
    options.target = in.number();
    options.max_evaluations = in.byte();
    options.max_iterations = in.byte();
  }
  obc_sphere_optimizer* solver = nullptr;
  std::vector<std::uint8_t> saved;
  if (ok([&](obc_error* e) {
        return obc_sphere_optimizer_create(count, dimension, &options, x0.data(), host.c(), &solver, e);
      })) {
    run(solver, in, &saved);
    obc_sphere_optimizer_destroy(solver);
    change(saved, in);
    obc_sphere_optimizer* loaded = nullptr;
    if (ok([&](obc_error* e) { return obc_sphere_optimizer_load(saved.data(), saved.size(), host.c(), &loaded, e); })) {
      run(loaded, in, nullptr);
      obc_sphere_optimizer_destroy(loaded);
    }
  }

  std::vector<std::size_t> starts = {0};
  for (std::size_t i = 0; i < count; ++i)
    starts.push_back(starts.back() + in.below(4));
  const auto neighbors = in.indices(starts.back(), count);
  if (count > 1 && in.one_in(10)) starts[1] = starts[2] + in.byte();
  obc_sphere_optimizer_blocks blocks;
  obc_sphere_optimizer_blocks_init(&blocks, sizeof blocks);
  blocks.dimension = static_cast<std::uint32_t>(dimension);
  blocks.count = count;
  blocks.neighbor_start = starts.data();
  blocks.neighbor = neighbors.data();
  obc_sphere_optimizer_relaxation_options relaxing;
  obc_sphere_optimizer_relaxation_options_init(&relaxing, sizeof relaxing);
  relaxing.max_passes = in.below(20);
  if (in.one_in(2)) {
    relaxing.method = in.choice(4);
    relaxing.second_order = in.choice(2);
    relaxing.order = in.choice(3);
    relaxing.gradient_tolerance = in.number();
    relaxing.relative_gain = in.number();
    relaxing.over_relaxation = in.one_in(2) ? in.number() : 0;
  }
  Part user{&in, dimension};
  auto x = x0;
  ok([&](obc_error* e) {
    return obc_sphere_optimizer_relax(&blocks, &relaxing, part, &user, x.data(), nullptr, host.c(), e);
  });
  obc_sphere_optimizer_relaxation* relaxation = nullptr;
  if (!ok([&](obc_error* e) {
        return obc_sphere_optimizer_relaxation_create(&blocks, &relaxing, x0.data(), host.c(), &relaxation, e);
      }))
    return 0;
  ok([&](obc_error* e) { return obc_sphere_optimizer_relaxation_run(relaxation, part, &user, in.byte(), e); });
  saved.resize(obc_sphere_optimizer_relaxation_save_size(relaxation));
  require(
      ok([&](obc_error* e) { return obc_sphere_optimizer_relaxation_save(relaxation, saved.data(), saved.size(), e); }),
      "a relaxation cannot be saved");
  obc_sphere_optimizer_relaxation_destroy(relaxation);
  change(saved, in);
  host.c();
  if (ok([&](obc_error* e) {
        return obc_sphere_optimizer_relaxation_load(&blocks, saved.data(), saved.size(), host.c(), &relaxation, e);
      })) {
    ok([&](obc_error* e) { return obc_sphere_optimizer_relaxation_run(relaxation, part, &user, in.byte(), e); });
    obc_sphere_optimizer_relaxation_result result;
    result.struct_size = sizeof result;
    require(
        ok([&](obc_error* e) { return obc_sphere_optimizer_relaxation_get_result(relaxation, &result, x.data(), e); }),
        "no result");
    obc_sphere_optimizer_relaxation_destroy(relaxation);
  }
  return 0;
}
