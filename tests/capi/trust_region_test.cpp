// The C interface of trust_region: arguments, memory, cancelling, callbacks, and a run that goes on in another process.
#include "orbicube/trust_region.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "failing_allocations.h"
#include "solver_checks.h"

using namespace orbicube;

namespace {

constexpr std::size_t unknowns = 4, residuals = 5;

// A signed sum of squares in a box that is active at the minimum, with residuals or as a scalar f.
struct Fixture {
  std::array<double, unknowns> lower{-1, -1, -1, -1}, upper{1, 0.3, 2, 2}, start{0.5, 0, 3, -0.5};
  std::array<double, residuals> sign{1, 1, 1, 1, -1};
  obc_trust_region_problem problem{};

  explicit Fixture(bool with_residuals) {
    obc_trust_region_problem_init(&problem, sizeof problem);
    problem.n = unknowns;
    problem.lower = lower.data();
    problem.upper = upper.data();
    if (with_residuals) {
      problem.residuals = residuals;
      problem.sign = sign.data();
    }
  }
};

std::array<double, residuals> residuals_at(const double* x) {
  return {10 * (x[1] - x[0] * x[0]), 1 - x[0], x[2] - x[3], std::exp(0.3 * x[3]) - 1.2, 0.1 * (x[0] + x[2])};
}

double value_at(const double* x) {
  const std::array<double, residuals> r = residuals_at(x);
  return r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3] - r[4] * r[4];
}

// f or the residuals, as the fixture's problem wants.
void evaluate(const Fixture& fixture, const double* x, double* outputs) {
  if (fixture.problem.residuals == 0) {
    *outputs = value_at(x);
    return;
  }
  const std::array<double, residuals> r = residuals_at(x);
  std::copy(r.begin(), r.end(), outputs);
}

struct Calls {
  const Fixture& fixture;
  int count = 0, stop_at = -1, fail_at = -1;
};

std::int32_t callback(const double* x, std::size_t n, double* outputs, void* user) {
  Calls& calls = *static_cast<Calls*>(user);
  if (n != unknowns) return OBC_TRUST_REGION_STOP;
  const int call = calls.count++;
  if (call == calls.stop_at) return OBC_TRUST_REGION_STOP;
  if (call == calls.fail_at) return OBC_TRUST_REGION_FAILED;
  evaluate(calls.fixture, x, outputs);
  return OBC_TRUST_REGION_CONTINUE;
}

obc_trust_region_result empty_result() {
  obc_trust_region_result result{};
  result.struct_size = sizeof result;
  return result;
}

struct Destroy {
  void operator()(obc_trust_region* solver) const { obc_trust_region_destroy(solver); }
};
using Handle = std::unique_ptr<obc_trust_region, Destroy>;

Handle create(const Fixture& fixture) {
  obc_trust_region* solver = nullptr;
  REQUIRE(obc_trust_region_create(&fixture.problem, nullptr, fixture.start.data(), nullptr, &solver, nullptr) ==
          OBC_OK);
  return Handle(solver);
}

// Fulfils requests until the end, or until `evaluations` values were supplied.
void drive(const Fixture& fixture, obc_trust_region* solver, int evaluations = -1) {
  const double* x = nullptr;
  std::size_t count = 0;
  std::array<double, residuals> outputs;
  for (std::int32_t request; (request = obc_trust_region_step(solver, &x, &count)) != OBC_TRUST_REGION_DONE;) {
    REQUIRE(request > 0);
    if (request != OBC_TRUST_REGION_NEED_VALUES) continue;
    REQUIRE(count >= 1);
    if (evaluations-- == 0) return;
    evaluate(fixture, x, outputs.data());
    REQUIRE(obc_trust_region_tell(solver, outputs.data(), nullptr) == OBC_OK);
  }
}

std::array<double, unknowns> best(const obc_trust_region* solver) {
  std::array<double, unknowns> x;
  REQUIRE(obc_trust_region_get_result(solver, nullptr, x.data(), nullptr, nullptr) == OBC_OK);
  return x;
}

}  // namespace

TEST_CASE(
    "Minimizing with a callback and by steps ends in the same bits, at the same minimum with residuals and without") {
  std::array<double, 2> minimum{};
  for (const bool with_residuals : {false, true}) {
    const Fixture fixture(with_residuals);
    Calls calls{fixture};
    std::array<double, unknowns> x = fixture.start;
    obc_trust_region_result result = empty_result();
    obc_error error;
    REQUIRE(obc_trust_region_minimize(&fixture.problem, nullptr, callback, &calls, x.data(), &result, nullptr,
                                      &error) == OBC_OK);
    CHECK(result.stop == OBC_TRUST_REGION_CONVERGED);
    CHECK(result.evaluations == static_cast<std::uint64_t>(calls.count));
    CHECK(result.value == doctest::Approx(value_at(x.data())).epsilon(1e-14));
    const Handle solver = create(fixture);
    drive(fixture, solver.get());
    CHECK(best(solver.get()) == x);
    std::array<double, residuals> outputs{}, expected{};
    REQUIRE(obc_trust_region_get_result(solver.get(), nullptr, nullptr, outputs.data(), nullptr) == OBC_OK);
    evaluate(fixture, x.data(), expected.data());
    CHECK(outputs == expected);
    minimum[with_residuals ? 1 : 0] = result.value;
  }
  CHECK(minimum[0] == doctest::Approx(minimum[1]).epsilon(1e-9));
}

TEST_CASE("Each allocation of create, load and minimize fails in turn and nothing is leaked") {
  for (const bool with_residuals : {false, true}) {
    const Fixture fixture(with_residuals);
    Handle saved = create(fixture);
    drive(fixture, saved.get(), 7);
    std::vector<unsigned char> blob(obc_trust_region_save_size(saved.get()));
    REQUIRE(obc_trust_region_save(saved.get(), blob.data(), blob.size(), nullptr) == OBC_OK);
    const auto created = test::fail_each_allocation([&](const obc_host& host) {
      obc_trust_region* solver = nullptr;
      const obc_status status =
          obc_trust_region_create(&fixture.problem, nullptr, fixture.start.data(), &host, &solver, nullptr);
      obc_trust_region_destroy(solver);
      return status;
    });
    CHECK(created.problem == "");
    CHECK(created.runs > 20);
    const auto loaded = test::fail_each_allocation([&](const obc_host& host) {
      obc_trust_region* solver = nullptr;
      const obc_status status =
          obc_trust_region_load(&fixture.problem, blob.data(), blob.size(), &host, &solver, nullptr);
      obc_trust_region_destroy(solver);
      return status;
    });
    CHECK(loaded.problem == "");
    const auto minimised = test::fail_each_allocation([&](const obc_host& host) {
      Calls calls{fixture};
      std::array<double, unknowns> x = fixture.start;
      return obc_trust_region_minimize(&fixture.problem, nullptr, callback, &calls, x.data(), nullptr, &host, nullptr);
    });
    CHECK(minimised.problem == "");
    // All memory is taken at the start: the run itself allocates only the outputs more than create.
    CHECK(minimised.runs <= created.runs + 1);
  }
}

TEST_CASE("A host can cancel at any report, and gets its best point") {
  const Fixture fixture(true);
  const auto outcome = test::cancel_everywhere([&](const obc_host& host) {
    Calls calls{fixture};
    std::array<double, unknowns> x = fixture.start;
    obc_trust_region_result result = empty_result();
    const obc_status status =
        obc_trust_region_minimize(&fixture.problem, nullptr, callback, &calls, x.data(), &result, &host, nullptr);
    const bool cancelled = result.stop == OBC_TRUST_REGION_CANCELLED;
    // Cancelled in the status if and only if in the result; with a value, x is where it was found.
    if (cancelled != (status == OBC_CANCELLED)) return static_cast<obc_status>(OBC_INTERNAL);
    if (!std::isnan(result.value) && std::abs(value_at(x.data()) - result.value) > 1e-12)
      return static_cast<obc_status>(OBC_INTERNAL);
    return status;
  });
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 1);
}

TEST_CASE("A callback can stop the run or say that f has no value") {
  const Fixture fixture(false);
  Calls stopping{fixture, 0, 6, -1};
  std::array<double, unknowns> x = fixture.start;
  obc_trust_region_result result = empty_result();
  CHECK(obc_trust_region_minimize(&fixture.problem, nullptr, callback, &stopping, x.data(), &result, nullptr,
                                  nullptr) == OBC_OK);
  CHECK(result.stop == OBC_TRUST_REGION_CANCELLED);
  CHECK(stopping.count == 7);
  CHECK(value_at(x.data()) == result.value);

  // What comes with STOP counts, and is the lowest here.
  for (const bool with_residuals : {false, true}) {
    const Fixture told(with_residuals);
    Calls last{told, 0, 6, -1};
    const obc_trust_region_function at_last = [](const double* at, std::size_t n, double* outputs,
                                                 void* user) -> std::int32_t {
      Calls& calls = *static_cast<Calls*>(user);
      if (calls.count < calls.stop_at) return callback(at, n, outputs, user);
      const std::array<double, unknowns> lowest{0.5, 0.25, 0.5, 0.5};
      evaluate(calls.fixture, lowest.data(), outputs);
      if (calls.fixture.problem.residuals == 0) *outputs = -1e6;
      ++calls.count;
      return OBC_TRUST_REGION_STOP;
    };
    x = told.start;
    CHECK(obc_trust_region_minimize(&told.problem, nullptr, at_last, &last, x.data(), &result, nullptr, nullptr) ==
          OBC_OK);
    CHECK(result.stop == OBC_TRUST_REGION_CANCELLED);
    CHECK(result.evaluations == 7);
    if (!with_residuals) CHECK(result.value == -1e6);
  }

  Calls failing{fixture, 0, -1, 3};
  x = fixture.start;
  CHECK(obc_trust_region_minimize(&fixture.problem, nullptr, callback, &failing, x.data(), &result, nullptr, nullptr) ==
        OBC_OK);
  CHECK(result.stop == OBC_TRUST_REGION_CONVERGED);
  CHECK(result.failed_evaluations == 1);
}

TEST_CASE("Points of a cross come at once, evaluations of before can be given, failures told without numbers") {
  const Fixture fixture(false);
  Handle solver = create(fixture);
  const double* x = nullptr;
  std::size_t count = 0;
  REQUIRE(obc_trust_region_step(solver.get(), &x, &count) == OBC_TRUST_REGION_NEED_VALUES);
  REQUIRE(count == 2 * unknowns + 1);
  std::vector<double> points(x, x + count * unknowns), values(count);
  for (std::size_t k = 0; k < count; ++k) {
    values[k] = value_at(points.data() + k * unknowns);
    REQUIRE(obc_trust_region_tell(solver.get(), k == 2 ? nullptr : &values[k], nullptr) == OBC_OK);
  }
  obc_trust_region_result result = empty_result();
  REQUIRE(obc_trust_region_get_result(solver.get(), &result, nullptr, nullptr, nullptr) == OBC_OK);
  CHECK(result.evaluations == count);
  CHECK(result.failed_evaluations == 1);
  CHECK(result.value == *std::min_element(values.begin(), values.end()));

  // All of them given to another run, which needs none for its start.
  solver = create(fixture);
  obc_error error;
  REQUIRE(obc_trust_region_give(solver.get(), points.data(), values.data(), count, &error) == OBC_OK);
  REQUIRE(obc_trust_region_step(solver.get(), &x, &count) == OBC_TRUST_REGION_NEED_VALUES);
  CHECK(count == 1);
  drive(fixture, solver.get());
  REQUIRE(obc_trust_region_get_result(solver.get(), &result, nullptr, nullptr, nullptr) == OBC_OK);
  CHECK(result.stop == OBC_TRUST_REGION_CONVERGED);
  CHECK(obc_trust_region_give(solver.get(), points.data(), values.data(), 1, &error) == OBC_INVALID_ARGUMENT);
  solver = create(fixture);
  points[0] = 7;
  CHECK(obc_trust_region_give(solver.get(), points.data(), values.data(), 1, &error) == OBC_INVALID_ARGUMENT);
}

TEST_CASE("Arguments that cannot be are refused") {
  const Fixture fixture(true);
  obc_trust_region* solver = nullptr;
  obc_error error;
  const auto refused = [&](const obc_trust_region_problem& problem, const obc_trust_region_options* options,
                           const double* start) {
    solver = reinterpret_cast<obc_trust_region*>(&error);
    return obc_trust_region_create(&problem, options, start, nullptr, &solver, &error) == OBC_INVALID_ARGUMENT &&
           solver == nullptr && error.message[0] != '\0';
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const int which : {0, 1, 2, 3, 4, 5}) {
    CAPTURE(which);
    Fixture wrong = fixture;
    wrong.problem.lower = wrong.lower.data();
    wrong.problem.upper = wrong.upper.data();
    wrong.problem.sign = wrong.sign.data();
    const std::array<double, unknowns> scale{1, 0, 1, 1};
    if (which == 0) wrong.problem.struct_size = 0;
    if (which == 1) wrong.problem.n = 0;
    if (which == 2) wrong.upper[2] = -3;
    if (which == 3) wrong.lower[1] = nan;
    if (which == 4) wrong.sign[0] = 0.5;
    if (which == 5) wrong.problem.scale = scale.data();
    CHECK(refused(wrong.problem, nullptr, fixture.start.data()));
  }
  std::array<double, unknowns> start = fixture.start;
  start[1] = nan;
  CHECK(refused(fixture.problem, nullptr, start.data()));
  for (const int which : {0, 1, 2, 3, 4, 5, 6, 7}) {
    CAPTURE(which);
    obc_trust_region_options options;
    obc_trust_region_options_init(&options, sizeof options);
    if (which == 0) options.method = 2;
    if (which == 1) options.start = 3;
    if (which == 2) options.points = unknowns + 1;
    if (which == 3) options.points = 16;
    if (which == 4) options.radius_begin = -1;
    if (which == 5) options.radius_end = 0;
    if (which == 6) options.noise_relative = nan;
    if (which == 7) options.target = nan;
    CHECK(refused(fixture.problem, &options, fixture.start.data()));
  }
  CHECK(obc_trust_region_create(nullptr, nullptr, start.data(), nullptr, &solver, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_trust_region_create(&fixture.problem, nullptr, nullptr, nullptr, &solver, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_trust_region_step(nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_trust_region_tell(nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_trust_region_get_result(nullptr, nullptr, nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_trust_region_save_size(nullptr) == 0);
  obc_trust_region_destroy(nullptr);
  const Handle idle = create(fixture);
  CHECK(obc_trust_region_tell(idle.get(), start.data(), &error) == OBC_INVALID_ARGUMENT);
}

TEST_CASE("A problem of zeros with its size is the one that init fills") {
  const std::array<double, 2> upper{0.5, 3};
  obc_trust_region_problem written{};
  written.struct_size = sizeof written;
  written.n = written.residuals = 2;
  written.upper = upper.data();
  obc_trust_region_problem filled;
  obc_trust_region_problem_init(&filled, sizeof filled);
  filled.n = filled.residuals = 2;
  filled.upper = upper.data();
  const obc_trust_region_function rosenbrock = [](const double* x, size_t, double* outputs, void*) -> int32_t {
    outputs[0] = 10 * (x[1] - x[0] * x[0]);
    outputs[1] = 1 - x[0];
    return OBC_TRUST_REGION_CONTINUE;
  };
  std::array<double, 2> x{-1.2, 1}, y = x;
  CHECK(obc_trust_region_minimize(&written, nullptr, rosenbrock, nullptr, x.data(), nullptr, nullptr, nullptr) ==
        OBC_OK);
  CHECK(obc_trust_region_minimize(&filled, nullptr, rosenbrock, nullptr, y.data(), nullptr, nullptr, nullptr) ==
        OBC_OK);
  CHECK(x == y);
  CHECK(x[0] == 0.5);
  CHECK(std::abs(x[1] - 0.25) < 1e-6);
}

TEST_CASE("Every stop has a name of its own") {
  CHECK(test::names_differ(obc_trust_region_stop_name, OBC_TRUST_REGION_EVALUATION_FAILED));
  CHECK(obc_trust_region_version() >= 100);
}

// The second half of the next test.
TEST_CASE("A run goes on from a file" * doctest::skip(!test::in_second_process())) {
  const Fixture fixture(true);
  const test::Bytes blob = test::blob_of_first_process();
  obc_trust_region* solver = nullptr;
  REQUIRE(obc_trust_region_load(&fixture.problem, blob.data(), blob.size(), nullptr, &solver, nullptr) == OBC_OK);
  const Handle handle(solver);
  drive(fixture, solver);
  const std::array<double, unknowns> x = best(solver);
  test::answer_first_process(x.data(), sizeof x);
}

TEST_CASE("Saved at each evaluation, a run goes on in a new process with the same bits") {
  const Fixture fixture(true);
  const Handle whole = create(fixture);
  drive(fixture, whole.get());
  obc_trust_region_result result = empty_result();
  REQUIRE(obc_trust_region_get_result(whole.get(), &result, nullptr, nullptr, nullptr) == OBC_OK);
  const std::array<double, unknowns> expected = best(whole.get());
  REQUIRE(result.evaluations > 10);
  for (int evaluation = 0; evaluation < static_cast<int>(result.evaluations); ++evaluation) {
    const Handle solver = create(fixture);
    drive(fixture, solver.get(), evaluation);
    test::Bytes blob(obc_trust_region_save_size(solver.get()));
    obc_error error;
    REQUIRE(obc_trust_region_save(solver.get(), blob.data(), blob.size() - 1, &error) == OBC_INVALID_ARGUMENT);
    REQUIRE(obc_trust_region_save(solver.get(), blob.data(), blob.size(), &error) == OBC_OK);
    const test::Bytes end = test::in_new_process("A run goes on from a file", blob);
    REQUIRE(end.size() == sizeof expected);
    CHECK(std::memcmp(end.data(), expected.data(), sizeof expected) == 0);
  }
}
