// The C interface of sphere_optimizer: arguments, memory, cancelling, callbacks, and a run that goes on in another
// process.
#include "orbicube/sphere_optimizer.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "charges.h"
#include "failing_allocations.h"
#include "solver_checks.h"

using namespace orbicube;
using namespace orbicube::test;

namespace {

struct Destroy {
  void operator()(obc_sphere_optimizer* solver) const { obc_sphere_optimizer_destroy(solver); }
};
using Handle = std::unique_ptr<obc_sphere_optimizer, Destroy>;

Handle create(const obc_sphere_optimizer_options* options = nullptr) {
  obc_sphere_optimizer* solver = nullptr;
  const Points x = start();
  REQUIRE(obc_sphere_optimizer_create(charges, 3, options, x.data(), nullptr, &solver, nullptr) == OBC_OK);
  return Handle(solver);
}

// Fulfils requests until the end, or until `evaluations` values were supplied.
void drive(obc_sphere_optimizer* solver, int evaluations = -1) {
  const double* x = nullptr;
  Points gradient;
  for (std::int32_t request; (request = obc_sphere_optimizer_step(solver, &x)) != OBC_SPHERE_OPTIMIZER_DONE;) {
    REQUIRE(request > 0);
    if (request != OBC_SPHERE_OPTIMIZER_NEED_FG) continue;
    if (evaluations-- == 0) return;
    REQUIRE(obc_sphere_optimizer_tell(solver, evaluate(x, gradient.data()), gradient.data(), nullptr) == OBC_OK);
  }
}

Points best(const obc_sphere_optimizer* solver) {
  Points x;
  REQUIRE(obc_sphere_optimizer_get_result(solver, nullptr, x.data(), nullptr) == OBC_OK);
  return x;
}

}  // namespace

TEST_CASE("Minimizing with a callback and by steps ends in the same bits") {
  for (const std::int32_t method : {OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY, OBC_SPHERE_OPTIMIZER_BARZILAI_BORWEIN,
                                    OBC_SPHERE_OPTIMIZER_GREAT_CIRCLE, OBC_SPHERE_OPTIMIZER_TRUNCATED_NEWTON}) {
    obc_sphere_optimizer_options options;
    REQUIRE(obc_sphere_optimizer_options_init(&options, sizeof options) == OBC_OK);
    options.method = method;
    options.gradient_tolerance = 1e-6;
    int calls = 0;
    Points x = start();
    auto result = empty<obc_sphere_optimizer_result>();
    obc_error error;
    REQUIRE(obc_sphere_optimizer_minimize(charges, 3, &options, callback, &calls, x.data(), &result, nullptr, &error) ==
            OBC_OK);
    CHECK(result.stop == OBC_SPHERE_OPTIMIZER_CONVERGED);
    CHECK(result.gradient_norm <= 1e-6);
    CHECK(result.evaluations == static_cast<std::uint64_t>(calls));
    const Handle solver = create(&options);
    drive(solver.get());
    CHECK(best(solver.get()) == x);
  }
}

TEST_CASE("Several starts are one run") {
  obc_sphere_optimizer_options options;
  REQUIRE(obc_sphere_optimizer_options_init(&options, sizeof options) == OBC_OK);
  CHECK(options.starts == 1);
  int calls = 0;
  const auto run = [&](std::uint64_t starts) {
    options.starts = starts;
    Points x = start();
    auto result = empty<obc_sphere_optimizer_result>();
    REQUIRE(obc_sphere_optimizer_minimize(charges, 3, &options, callback, &calls, x.data(), &result, nullptr,
                                          nullptr) == OBC_OK);
    CHECK(result.stop == OBC_SPHERE_OPTIMIZER_CONVERGED);
    CHECK(result.starts == starts);
    CHECK(result.best_start < starts);
    Points gradient;
    CHECK(evaluate(x.data(), gradient.data()) == result.value);
    return result;
  };
  const obc_sphere_optimizer_result one = run(1), five = run(5);
  CHECK(five.value <= one.value);
  CHECK(static_cast<std::uint64_t>(calls) == one.evaluations + five.evaluations);
}

TEST_CASE("Block by block, with gradients or Hessians, the same energy is reached as all at once") {
  const Blocks fixture;
  Points gradient, together = start();
  REQUIRE(obc_sphere_optimizer_minimize(charges, 3, nullptr, callback, nullptr, together.data(), nullptr, nullptr,
                                        nullptr) == OBC_OK);
  const double least = evaluate(together.data(), gradient.data());
  for (const std::int32_t second_order : {0, 1}) {
    obc_sphere_optimizer_relaxation_options options;
    REQUIRE(obc_sphere_optimizer_relaxation_options_init(&options, sizeof options) == OBC_OK);
    options.second_order = second_order;
    // Near the place where all at once ended; there are several minima.
    Points x = together;
    for (std::size_t k = 0; k < unknowns; ++k)
      x[k] += 0.1 * start()[k];
    auto result = empty<obc_sphere_optimizer_relaxation_result>();
    int calls = 0;
    REQUIRE(obc_sphere_optimizer_relax(&fixture.blocks, &options, block_callback, &calls, x.data(), &result, nullptr,
                                       nullptr) == OBC_OK);
    CHECK(result.stop == OBC_SPHERE_OPTIMIZER_CONVERGED);
    CHECK(result.gradient_norm <= 1e-6);
    CHECK(result.evaluations == static_cast<std::uint64_t>(calls));
    CHECK(evaluate(x.data(), gradient.data()) == doctest::Approx(least).epsilon(1e-10));
  }
}

TEST_CASE("A run that was loaded knows its shape") {
  const Handle saved = create();
  std::vector<unsigned char> blob(obc_sphere_optimizer_save_size(saved.get()));
  REQUIRE(obc_sphere_optimizer_save(saved.get(), blob.data(), blob.size(), nullptr) == OBC_OK);
  obc_sphere_optimizer* loaded = nullptr;
  REQUIRE(obc_sphere_optimizer_load(blob.data(), blob.size(), nullptr, &loaded, nullptr) == OBC_OK);
  size_t count = 0, dimension = 0;
  CHECK(obc_sphere_optimizer_get_shape(loaded, &count, &dimension, nullptr) == OBC_OK);
  CHECK(count == charges);
  CHECK(dimension == 3);
  CHECK(obc_sphere_optimizer_get_shape(loaded, nullptr, nullptr, nullptr) == OBC_OK);
  obc_sphere_optimizer_destroy(loaded);
}

TEST_CASE("Each allocation of create, load, minimize and relax fails in turn and nothing is leaked") {
  Handle saved = create();
  drive(saved.get(), 5);
  std::vector<unsigned char> blob(obc_sphere_optimizer_save_size(saved.get()));
  REQUIRE(obc_sphere_optimizer_save(saved.get(), blob.data(), blob.size(), nullptr) == OBC_OK);
  const auto created = test::fail_each_allocation([&](const obc_host& host) {
    obc_sphere_optimizer* solver = nullptr;
    const Points x = start();
    const obc_status status = obc_sphere_optimizer_create(charges, 3, nullptr, x.data(), &host, &solver, nullptr);
    obc_sphere_optimizer_destroy(solver);
    return status;
  });
  CHECK(created.problem == "");
  CHECK(created.runs > 10);
  const auto loaded = test::fail_each_allocation([&](const obc_host& host) {
    obc_sphere_optimizer* solver = nullptr;
    const obc_status status = obc_sphere_optimizer_load(blob.data(), blob.size(), &host, &solver, nullptr);
    obc_sphere_optimizer_destroy(solver);
    return status;
  });
  CHECK(loaded.problem == "");
  const auto minimised = test::fail_each_allocation([&](const obc_host& host) {
    Points x = start();
    return obc_sphere_optimizer_minimize(charges, 3, nullptr, callback, nullptr, x.data(), nullptr, &host, nullptr);
  });
  CHECK(minimised.problem == "");
  // All memory is taken at the start: the run itself allocates only the gradient more than create.
  CHECK(minimised.runs <= created.runs + 1);
  const Blocks fixture;
  const auto relaxed = test::fail_each_allocation([&](const obc_host& host) {
    Points x = start();
    return obc_sphere_optimizer_relax(&fixture.blocks, nullptr, block_callback, nullptr, x.data(), nullptr, &host,
                                      nullptr);
  });
  CHECK(relaxed.problem == "");
  CHECK(relaxed.runs > 3);
}

TEST_CASE("A million quaternions take steps without an allocation") {
  // Each is drawn to the next and to its own place: f = sum 1 - (q_i . q_i+1)^2 + |q_i - p_i|^2 / 2.
  constexpr std::size_t count = 1000000;
  std::vector<double> x(4 * count), gradient(4 * count);
  for (std::size_t k = 0; k < 4 * count; ++k)
    x[k] = std::sin(static_cast<double>(k % 1000003) * 1.7) + (k % 4 == 0 ? 1 : 0);
  const std::vector<double> place = x;
  const auto evaluate_all = [&](const double* q) {
    double f = 0;
    for (std::size_t k = 0; k < 4 * count; ++k) {
      gradient[k] = q[k] - place[k];
      f += 0.5 * gradient[k] * gradient[k];
    }
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const double *a = q + 4 * i, *b = a + 4;
      const double along = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
      f += 1 - along * along;
      for (std::size_t k = 0; k < 4; ++k) {
        gradient[4 * i + k] -= 2 * along * b[k];
        gradient[4 * i + 4 + k] -= 2 * along * a[k];
      }
    }
    return f;
  };
  obc_sphere_optimizer_options options;
  obc_sphere_optimizer_options_init(&options, sizeof options);
  options.memory = 2;
  obc_sphere_optimizer* solver = nullptr;
  REQUIRE(obc_sphere_optimizer_create(count, 4, &options, x.data(), nullptr, &solver, nullptr) == OBC_OK);
  const Handle handle(solver);
  const std::size_t before = test::allocation_count();
  const double* point = nullptr;
  double first = 0, last = 0;
  for (int evaluation = 0; evaluation < 5;) {
    if (obc_sphere_optimizer_step(solver, &point) != OBC_SPHERE_OPTIMIZER_NEED_FG) continue;
    last = evaluate_all(point);
    if (evaluation++ == 0) first = last;
    if (obc_sphere_optimizer_tell(solver, last, gradient.data(), nullptr) != OBC_OK) break;
  }
  CHECK(test::allocation_count() == before);
  CHECK(last < first);
}

TEST_CASE("A host can cancel at any report, and gets its best point") {
  const auto minimised = test::cancel_everywhere([&](const obc_host& host) {
    Points x = start(), gradient;
    auto result = empty<obc_sphere_optimizer_result>();
    const obc_status status =
        obc_sphere_optimizer_minimize(charges, 3, nullptr, callback, nullptr, x.data(), &result, &host, nullptr);
    const bool cancelled = result.stop == OBC_SPHERE_OPTIMIZER_CANCELLED;
    // Cancelled in the status if and only if in the result; with a value, x is where it was found.
    if (cancelled != (status == OBC_CANCELLED)) return static_cast<obc_status>(OBC_INTERNAL);
    if (!std::isnan(result.value) && evaluate(x.data(), gradient.data()) != result.value) {
      return static_cast<obc_status>(OBC_INTERNAL);
    }
    return status;
  });
  CHECK(minimised.problem == "");
  CHECK(minimised.runs > 1);
  const Blocks fixture;
  const auto relaxed = test::cancel_everywhere([&](const obc_host& host) {
    Points x = start();
    auto result = empty<obc_sphere_optimizer_relaxation_result>();
    const obc_status status = obc_sphere_optimizer_relax(&fixture.blocks, nullptr, block_callback, nullptr, x.data(),
                                                         &result, &host, nullptr);
    const bool cancelled = result.stop == OBC_SPHERE_OPTIMIZER_CANCELLED;
    return cancelled == (status == OBC_CANCELLED) ? status : static_cast<obc_status>(OBC_INTERNAL);
  });
  CHECK(relaxed.problem == "");
  CHECK(relaxed.runs > 1);
}

TEST_CASE("A callback can stop the run or say that f has no value") {
  struct Plan {
    int calls = 0, stop_at = -1, fail_at = -1;
  };
  const obc_sphere_optimizer_function f = [](const double* x, std::size_t, std::size_t, double* value, double* gradient,
                                             void* user) -> std::int32_t {
    Plan& plan = *static_cast<Plan*>(user);
    const int call = plan.calls++;
    if (call == plan.stop_at) return OBC_SPHERE_OPTIMIZER_STOP;
    if (call == plan.fail_at) return OBC_SPHERE_OPTIMIZER_FAILED;
    *value = evaluate(x, gradient);
    return OBC_SPHERE_OPTIMIZER_CONTINUE;
  };
  Plan stopping{0, 4, -1};
  Points x = start(), gradient;
  auto result = empty<obc_sphere_optimizer_result>();
  CHECK(obc_sphere_optimizer_minimize(charges, 3, nullptr, f, &stopping, x.data(), &result, nullptr, nullptr) ==
        OBC_OK);
  CHECK(result.stop == OBC_SPHERE_OPTIMIZER_CANCELLED);
  CHECK(stopping.calls == 5);
  CHECK(evaluate(x.data(), gradient.data()) == result.value);
  // The value that comes with STOP counts.
  int calls = 0;
  const obc_sphere_optimizer_function at_last = [](const double* at, std::size_t, std::size_t, double* value,
                                                   double* slopes, void* user) -> std::int32_t {
    *value = evaluate(at, slopes);
    if (++*static_cast<int*>(user) < 3) return OBC_SPHERE_OPTIMIZER_CONTINUE;
    *value = -1e6;
    return OBC_SPHERE_OPTIMIZER_STOP;
  };
  x = start();
  CHECK(obc_sphere_optimizer_minimize(charges, 3, nullptr, at_last, &calls, x.data(), &result, nullptr, nullptr) ==
        OBC_OK);
  CHECK(result.stop == OBC_SPHERE_OPTIMIZER_CANCELLED);
  CHECK(result.value == -1e6);
  CHECK(result.evaluations == 3);

  Plan failing{0, -1, 3};
  x = start();
  CHECK(obc_sphere_optimizer_minimize(charges, 3, nullptr, f, &failing, x.data(), &result, nullptr, nullptr) == OBC_OK);
  CHECK(result.stop == OBC_SPHERE_OPTIMIZER_CONVERGED);
  CHECK(result.failed_evaluations == 1);

  const obc_sphere_optimizer_block_function part = [](std::size_t block, const double* place, const double* points,
                                                      double* value, double* slope, double* hessian,
                                                      void* user) -> std::int32_t {
    Plan& plan = *static_cast<Plan*>(user);
    const int call = plan.calls++;
    if (call == plan.stop_at) return OBC_SPHERE_OPTIMIZER_STOP;
    if (call == plan.fail_at) return OBC_SPHERE_OPTIMIZER_FAILED;
    return block_callback(block, place, points, value, slope, hessian, nullptr);
  };
  const Blocks fixture;
  auto report = empty<obc_sphere_optimizer_relaxation_result>();
  stopping = {0, 30, -1};
  x = start();
  const double before = [&] {
    Points unit = start();
    for (std::size_t i = 0; i < charges; ++i) {
      const double length = std::hypot(unit[3 * i], unit[3 * i + 1], unit[3 * i + 2]);
      for (std::size_t k = 0; k < 3; ++k)
        unit[3 * i + k] /= length;
    }
    return evaluate(unit.data(), gradient.data());
  }();
  CHECK(obc_sphere_optimizer_relax(&fixture.blocks, nullptr, part, &stopping, x.data(), &report, nullptr, nullptr) ==
        OBC_OK);
  CHECK(report.stop == OBC_SPHERE_OPTIMIZER_CANCELLED);
  CHECK(stopping.calls == 31);
  CHECK(report.gain > 0);
  CHECK(evaluate(x.data(), gradient.data()) == doctest::Approx(before - report.gain).epsilon(1e-12));
  for (int fail_at = 0; fail_at < 40; ++fail_at) {
    failing = {0, -1, fail_at};
    x = start();
    CHECK(obc_sphere_optimizer_relax(&fixture.blocks, nullptr, part, &failing, x.data(), &report, nullptr, nullptr) ==
          OBC_OK);
    CHECK(report.stop == OBC_SPHERE_OPTIMIZER_CONVERGED);
  }
}

TEST_CASE("Arguments that cannot be are refused") {
  obc_sphere_optimizer* solver = nullptr;
  obc_error error;
  const Points x = start();
  const auto refused = [&](std::size_t count, std::size_t dimension, const obc_sphere_optimizer_options* options,
                           const double* from) {
    solver = reinterpret_cast<obc_sphere_optimizer*>(&error);
    return obc_sphere_optimizer_create(count, dimension, options, from, nullptr, &solver, &error) ==
               OBC_INVALID_ARGUMENT &&
           error.message[0] != '\0';
  };
  CHECK(refused(0, 3, nullptr, x.data()));
  CHECK(refused(charges, 1, nullptr, x.data()));
  CHECK(refused(charges, 3, nullptr, nullptr));
  CHECK(refused(std::numeric_limits<std::size_t>::max() / 2, 3, nullptr, x.data()));
  Points bad = x;
  bad[4] = std::numeric_limits<double>::infinity();
  CHECK(refused(charges, 3, nullptr, bad.data()));
  bad[3] = bad[4] = bad[5] = 0;
  CHECK(refused(charges, 3, nullptr, bad.data()));
  obc_sphere_optimizer_options options;
  for (const int which : {0, 1, 2, 3, 4, 5, 6}) {
    obc_sphere_optimizer_options_init(&options, sizeof options);
    if (which == 6) options.starts = 0;
    if (which == 0) options.method = 5;
    if (which == 1) options.method = -1;
    if (which == 2) options.memory = 0;
    if (which == 3) options.history = 0;
    if (which == 4) options.gradient_tolerance = std::numeric_limits<double>::quiet_NaN();
    if (which == 5) options.struct_size = 0;
    CHECK(refused(charges, 3, &options, x.data()));
  }
  CHECK(obc_sphere_optimizer_step(nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_optimizer_tell(nullptr, 0, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_optimizer_get_result(nullptr, nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_optimizer_save_size(nullptr) == 0);
  CHECK(obc_sphere_optimizer_get_shape(nullptr, nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_sphere_optimizer_load("nothing", 7, nullptr, &solver, &error) == OBC_MALFORMED_FILE);
  obc_sphere_optimizer_destroy(nullptr);

  const auto refused_blocks = [&](const obc_sphere_optimizer_blocks& blocks,
                                  const obc_sphere_optimizer_relaxation_options* relaxation) {
    Points y = start();
    return obc_sphere_optimizer_relax(&blocks, relaxation, block_callback, nullptr, y.data(), nullptr, nullptr,
                                      &error) == OBC_INVALID_ARGUMENT;
  };
  Blocks fixture;
  obc_sphere_optimizer_blocks blocks = fixture.blocks;
  blocks.dimension = 65;
  CHECK(refused_blocks(blocks, nullptr));
  blocks = fixture.blocks;
  blocks.count = 0;
  CHECK(refused_blocks(blocks, nullptr));
  blocks = fixture.blocks;
  blocks.neighbor = nullptr;
  CHECK(refused_blocks(blocks, nullptr));
  fixture.neighbor[3] = charges;
  CHECK(refused_blocks(fixture.blocks, nullptr));
  fixture.neighbor[3] = 1;
  fixture.start[1] = charges * charges;
  CHECK(refused_blocks(fixture.blocks, nullptr));
  const Blocks good;
  obc_sphere_optimizer_relaxation_options relaxation;
  obc_sphere_optimizer_relaxation_options_init(&relaxation, sizeof relaxation);
  relaxation.method = OBC_SPHERE_OPTIMIZER_LIMITED_MEMORY;
  CHECK(refused_blocks(good.blocks, &relaxation));
  obc_sphere_optimizer_relaxation_options_init(&relaxation, sizeof relaxation);
  relaxation.gradient_tolerance = -1;
  CHECK(refused_blocks(good.blocks, &relaxation));
}

TEST_CASE("Every stop has a name of its own") {
  CHECK(test::names_differ(obc_sphere_optimizer_stop_name, OBC_SPHERE_OPTIMIZER_EVALUATION_FAILED));
  CHECK(obc_sphere_optimizer_version() >= 100);
}

// The second half of the next test.
TEST_CASE("A run goes on from a file" * doctest::skip(!test::in_second_process())) {
  const test::Bytes blob = test::blob_of_first_process();
  obc_sphere_optimizer* solver = nullptr;
  REQUIRE(obc_sphere_optimizer_load(blob.data(), blob.size(), nullptr, &solver, nullptr) == OBC_OK);
  const Handle handle(solver);
  drive(solver);
  const Points x = best(solver);
  test::answer_first_process(x.data(), sizeof x);
}

TEST_CASE("Saved at each evaluation, a run goes on in a new process with the same bits") {
  const Handle whole = create();
  drive(whole.get());
  auto result = empty<obc_sphere_optimizer_result>();
  REQUIRE(obc_sphere_optimizer_get_result(whole.get(), &result, nullptr, nullptr) == OBC_OK);
  const Points expected = best(whole.get());
  REQUIRE(result.evaluations > 20);
  for (int evaluation = 0; evaluation < static_cast<int>(result.evaluations); ++evaluation) {
    const Handle solver = create();
    drive(solver.get(), evaluation);
    test::Bytes blob(obc_sphere_optimizer_save_size(solver.get()));
    obc_error error;
    REQUIRE(obc_sphere_optimizer_save(solver.get(), blob.data(), blob.size() - 1, &error) == OBC_INVALID_ARGUMENT);
    REQUIRE(obc_sphere_optimizer_save(solver.get(), blob.data(), blob.size(), &error) == OBC_OK);
    const test::Bytes end = test::in_new_process("A run goes on from a file", blob);
    REQUIRE(end.size() == sizeof expected);
    CHECK(std::memcmp(end.data(), expected.data(), sizeof expected) == 0);
  }
}
