// The C interface of sphere_optimizer, block by block and in parts: breaks, saved runs, memory.
#include <doctest/doctest.h>

#include <cstring>
#include <memory>

#include "charges.h"
#include "failing_allocations.h"
#include "solver_checks.h"

using namespace orbicube;
using namespace orbicube::test;

namespace {

struct DestroyRelaxation {
  void operator()(obc_sphere_optimizer_relaxation* relaxation) const {
    obc_sphere_optimizer_relaxation_destroy(relaxation);
  }
};
using RelaxationHandle = std::unique_ptr<obc_sphere_optimizer_relaxation, DestroyRelaxation>;

obc_sphere_optimizer_relaxation_options relaxation_options(std::int32_t second_order = 0,
                                                           std::int32_t method = OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE) {
  obc_sphere_optimizer_relaxation_options options;
  obc_sphere_optimizer_relaxation_options_init(&options, sizeof options);
  options.second_order = second_order;
  options.method = method;
  options.max_passes = 20;
  return options;
}

RelaxationHandle create_relaxation(const Blocks& fixture, const obc_sphere_optimizer_relaxation_options& options,
                                   const obc_host* host = nullptr) {
  obc_sphere_optimizer_relaxation* relaxation = nullptr;
  const Points x = start();
  REQUIRE(obc_sphere_optimizer_relaxation_create(&fixture.blocks, &options, x.data(), host, &relaxation, nullptr) ==
          OBC_OK);
  return RelaxationHandle(relaxation);
}

struct Relaxed {
  obc_sphere_optimizer_relaxation_result result = empty<obc_sphere_optimizer_relaxation_result>();
  Points x;
  bool operator==(const Relaxed& other) const {
    return std::memcmp(&result, &other.result, sizeof result) == 0 &&
           std::memcmp(x.data(), other.x.data(), sizeof x) == 0;
  }
};

Relaxed state_of(const RelaxationHandle& relaxation) {
  Relaxed state;
  REQUIRE(obc_sphere_optimizer_relaxation_get_result(relaxation.get(), &state.result, state.x.data(), nullptr) ==
          OBC_OK);
  return state;
}

obc_status run(const RelaxationHandle& relaxation, std::uint64_t steps = UINT64_MAX, int* calls = nullptr) {
  return obc_sphere_optimizer_relaxation_run(relaxation.get(), block_callback, calls, steps, nullptr);
}

// Plain steps, Newton's, and Algorithm 2 as printed.
const auto every_relaxation = {relaxation_options(), relaxation_options(1),
                               relaxation_options(0, OBC_SPHERE_OPTIMIZER_DISSERTATION)};

}  // namespace

TEST_CASE("A relaxation in parts, or stopped at any evaluation, ends in the bits of one without a break") {
  const Blocks fixture;
  for (const auto& options : every_relaxation) {
    Points x = start();
    Relaxed whole;
    int calls = 0;
    REQUIRE(obc_sphere_optimizer_relax(&fixture.blocks, &options, block_callback, &calls, x.data(), &whole.result,
                                       nullptr, nullptr) == OBC_OK);
    whole.x = x;
    const RelaxationHandle parts = create_relaxation(fixture, options);
    int rounds = 0;
    for (; state_of(parts).result.stop == OBC_SPHERE_OPTIMIZER_RUNNING; ++rounds)
      REQUIRE(run(parts, 3) == OBC_OK);
    CHECK(state_of(parts) == whole);
    CHECK(rounds >= static_cast<int>(whole.result.steps / 3));
    struct Plan {
      int left;
    };
    const obc_sphere_optimizer_block_function stopping = [](std::size_t block, const double* place,
                                                            const double* points, double* value, double* gradient,
                                                            double* hessian, void* user) -> std::int32_t {
      if (static_cast<Plan*>(user)->left-- == 0) return OBC_SPHERE_OPTIMIZER_STOP;
      return block_callback(block, place, points, value, gradient, hessian, nullptr);
    };
    for (int last = 0; last < calls; ++last) {
      const RelaxationHandle stopped = create_relaxation(fixture, options);
      Plan plan{last};
      REQUIRE(obc_sphere_optimizer_relaxation_run(stopped.get(), stopping, &plan, UINT64_MAX, nullptr) == OBC_OK);
      CHECK(state_of(stopped).result.stop == OBC_SPHERE_OPTIMIZER_CANCELLED);
      REQUIRE(run(stopped) == OBC_OK);
      CHECK(state_of(stopped) == whole);
    }
  }
}

// The second half of the next test.
TEST_CASE("A relaxation goes on from a file" * doctest::skip(!test::in_second_process())) {
  const Blocks fixture;
  const test::Bytes blob = test::blob_of_first_process();
  obc_sphere_optimizer_relaxation* relaxation = nullptr;
  REQUIRE(obc_sphere_optimizer_relaxation_load(&fixture.blocks, blob.data(), blob.size(), nullptr, &relaxation,
                                               nullptr) == OBC_OK);
  const RelaxationHandle handle(relaxation);
  REQUIRE(run(handle) == OBC_OK);
  const Relaxed end = state_of(handle);
  test::answer_first_process(&end, sizeof end);
}

TEST_CASE("Saved after each step, a relaxation goes on in a new process with the same bits") {
  const Blocks fixture;
  for (auto options : every_relaxation) {
    options.max_passes = 3;
    const RelaxationHandle whole = create_relaxation(fixture, options);
    REQUIRE(run(whole) == OBC_OK);
    const Relaxed expected = state_of(whole);
    REQUIRE(expected.result.steps > 20);
    for (std::uint64_t step = 0; step <= expected.result.steps; ++step) {
      const RelaxationHandle relaxation = create_relaxation(fixture, options);
      REQUIRE(run(relaxation, step) == OBC_OK);
      test::Bytes blob(obc_sphere_optimizer_relaxation_save_size(relaxation.get()));
      REQUIRE(obc_sphere_optimizer_relaxation_save(relaxation.get(), blob.data(), blob.size(), nullptr) == OBC_OK);
      const test::Bytes end = test::in_new_process("A relaxation goes on from a file", blob);
      REQUIRE(end.size() == sizeof expected);
      CHECK(std::memcmp(end.data(), &expected, sizeof expected) == 0);
    }
  }
}

TEST_CASE("A saved relaxation that is damaged, or of other neighbors, is refused") {
  const Blocks fixture;
  const RelaxationHandle relaxation = create_relaxation(fixture, relaxation_options());
  REQUIRE(run(relaxation, 10) == OBC_OK);
  test::Bytes blob(obc_sphere_optimizer_relaxation_save_size(relaxation.get()));
  CHECK(obc_sphere_optimizer_relaxation_save(relaxation.get(), blob.data(), blob.size() - 1, nullptr) ==
        OBC_INVALID_ARGUMENT);
  REQUIRE(obc_sphere_optimizer_relaxation_save(relaxation.get(), blob.data(), blob.size(), nullptr) == OBC_OK);
  obc_sphere_optimizer_relaxation* loaded = nullptr;
  const auto load = [&](const Blocks& blocks, const test::Bytes& bytes) {
    const obc_status status =
        obc_sphere_optimizer_relaxation_load(&blocks.blocks, bytes.data(), bytes.size(), nullptr, &loaded, nullptr);
    CHECK((loaded == nullptr) == (status != OBC_OK));
    return status;
  };
  for (std::size_t i = 0; i < blob.size(); i += 97) {
    test::Bytes damaged = blob;
    damaged[i] ^= 0x10;
    CHECK(load(fixture, damaged) == OBC_MALFORMED_FILE);
  }
  CHECK(load(fixture, test::Bytes(blob.begin(), blob.end() - 1)) == OBC_MALFORMED_FILE);
  Blocks other;
  std::swap(other.neighbor[0], other.neighbor[1]);
  CHECK(load(other, blob) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_optimizer_relaxation_run(nullptr, block_callback, nullptr, 1, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_optimizer_relaxation_run(relaxation.get(), nullptr, nullptr, 1, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_optimizer_relaxation_save_size(nullptr) == 0);
  obc_sphere_optimizer_relaxation_destroy(nullptr);
}

TEST_CASE("A relaxation in parts keeps its promises about memory and hosts") {
  const Blocks fixture;
  test::Bytes blob;
  {
    const RelaxationHandle relaxation = create_relaxation(fixture, relaxation_options());
    blob.resize(obc_sphere_optimizer_relaxation_save_size(relaxation.get()));
    REQUIRE(obc_sphere_optimizer_relaxation_save(relaxation.get(), blob.data(), blob.size(), nullptr) == OBC_OK);
    const std::size_t before = test::allocation_count();
    CHECK(run(relaxation) == OBC_OK);
    CHECK(test::allocation_count() == before);
  }
  for (const bool load : {false, true}) {
    const auto outcome = test::fail_each_allocation([&](const obc_host& host) {
      obc_sphere_optimizer_relaxation* made = nullptr;
      const Points x = start();
      const obc_status status =
          load ? obc_sphere_optimizer_relaxation_load(&fixture.blocks, blob.data(), blob.size(), &host, &made, nullptr)
               : obc_sphere_optimizer_relaxation_create(&fixture.blocks, nullptr, x.data(), &host, &made, nullptr);
      obc_sphere_optimizer_relaxation_destroy(made);
      return status;
    });
    CHECK(outcome.problem == "");
    CHECK(outcome.runs > 6);
  }
  const auto cancelled = test::cancel_everywhere([&](const obc_host& host) {
    const RelaxationHandle relaxation = create_relaxation(fixture, relaxation_options(), &host);
    const obc_status status = run(relaxation);
    const bool in_result = state_of(relaxation).result.stop == OBC_SPHERE_OPTIMIZER_CANCELLED;
    return in_result == (status == OBC_CANCELLED) ? status : static_cast<obc_status>(OBC_INTERNAL);
  });
  CHECK(cancelled.problem == "");
  CHECK(cancelled.runs > 1);
}
