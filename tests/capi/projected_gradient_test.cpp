// The C interface of projected_gradient: arguments, memory, cancelling, callbacks, and a run that goes on in another
// process.
#include "orbicube/projected_gradient.h"

#include <doctest/doctest.h>

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

constexpr std::size_t unknowns = 6;

// min sum w_j (x_j - j)^2 / 2 + (x_0 - x_1)^4 over two rows and a box.
struct Fixture {
  std::array<double, unknowns> lower{-1, -1, -1, -1, -1, -1}, upper{1, 2, 2, 2, 2, 1.5}, start{5, 5, 5, -5, -5, 0};
  std::array<std::size_t, 3> row_start{0, 4, 7};
  std::array<std::uint32_t, 7> column{0, 1, 2, 5, 1, 3, 4};
  std::array<double, 7> value{1, 2, -1, 1, 3, 1, -2};
  std::array<double, 2> b{0.5, 1};
  obc_projected_gradient_problem problem{};

  Fixture() {
    obc_projected_gradient_problem_init(&problem, sizeof problem);
    problem.n = unknowns;
    problem.m = 2;
    problem.lower = lower.data();
    problem.upper = upper.data();
    problem.row_start = row_start.data();
    problem.column = column.data();
    problem.value = value.data();
    problem.b = b.data();
  }
};

double evaluate(const double* x, double* gradient) {
  double f = 0;
  for (std::size_t j = 0; j < unknowns; ++j) {
    const double weight = static_cast<double>(j + 1), away = x[j] - static_cast<double>(j);
    gradient[j] = weight * away;
    f += 0.5 * weight * away * away;
  }
  const double difference = x[0] - x[1], cube = difference * difference * difference;
  gradient[0] += 4 * cube;
  gradient[1] -= 4 * cube;
  return f + cube * difference;
}

std::int32_t callback(const double* x, std::size_t n, double* value, double* gradient, void* user) {
  if (n != unknowns) return OBC_PROJECTED_GRADIENT_STOP;
  if (user != nullptr) ++*static_cast<int*>(user);
  *value = evaluate(x, gradient);
  return OBC_PROJECTED_GRADIENT_CONTINUE;
}

obc_projected_gradient_result empty_result() {
  obc_projected_gradient_result result{};
  result.struct_size = sizeof result;
  return result;
}

struct Destroy {
  void operator()(obc_projected_gradient* solver) const { obc_projected_gradient_destroy(solver); }
};
using Handle = std::unique_ptr<obc_projected_gradient, Destroy>;

Handle create(const Fixture& fixture) {
  obc_projected_gradient* solver = nullptr;
  REQUIRE(obc_projected_gradient_create(&fixture.problem, nullptr, fixture.start.data(), nullptr, &solver, nullptr) ==
          OBC_OK);
  return Handle(solver);
}

// Fulfils requests until the end, or until `evaluations` values were supplied.
void drive(obc_projected_gradient* solver, int evaluations = -1) {
  const double* x = nullptr;
  std::array<double, unknowns> gradient;
  for (std::int32_t request; (request = obc_projected_gradient_step(solver, &x)) != OBC_PROJECTED_GRADIENT_DONE;) {
    REQUIRE(request > 0);
    if (request != OBC_PROJECTED_GRADIENT_NEED_FG) continue;
    if (evaluations-- == 0) return;
    const double f = evaluate(x, gradient.data());
    REQUIRE(obc_projected_gradient_tell(solver, f, gradient.data(), nullptr) == OBC_OK);
  }
}

std::array<double, unknowns> best(const obc_projected_gradient* solver) {
  std::array<double, unknowns> x;
  REQUIRE(obc_projected_gradient_get_result(solver, nullptr, x.data(), nullptr) == OBC_OK);
  return x;
}

}  // namespace

TEST_CASE("Minimizing with a callback and by steps ends in the same bits") {
  const Fixture fixture;
  int calls = 0;
  std::array<double, unknowns> x = fixture.start;
  obc_projected_gradient_result result = empty_result();
  obc_error error;
  REQUIRE(obc_projected_gradient_minimize(&fixture.problem, nullptr, callback, &calls, x.data(), &result, nullptr,
                                          &error) == OBC_OK);
  CHECK(result.stop == OBC_PROJECTED_GRADIENT_CONVERGED);
  CHECK(result.projected_gradient <= 1e-8);
  CHECK(result.equality_residual < 1e-14);
  CHECK(result.evaluations == static_cast<std::uint64_t>(calls));
  const Handle solver = create(fixture);
  drive(solver.get());
  CHECK(best(solver.get()) == x);

  // Stationary with the multipliers that the interface gives.
  std::array<double, 2> t;
  REQUIRE(obc_projected_gradient_multipliers(solver.get(), t.data(), &error) == OBC_OK);
  std::array<double, unknowns> slope;
  evaluate(x.data(), slope.data());
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = fixture.row_start[i]; k < fixture.row_start[i + 1]; ++k)
      slope[fixture.column[k]] -= fixture.value[k] * t[i];
  }
  for (std::size_t j = 0; j < unknowns; ++j) {
    if (x[j] > fixture.lower[j]) CHECK(slope[j] < 1e-7);
    if (x[j] < fixture.upper[j]) CHECK(slope[j] > -1e-7);
  }
}

TEST_CASE("Each allocation of create, load, minimize and project fails in turn and nothing is leaked") {
  const Fixture fixture;
  Handle saved = create(fixture);
  drive(saved.get(), 3);
  std::vector<unsigned char> blob(obc_projected_gradient_save_size(saved.get()));
  REQUIRE(obc_projected_gradient_save(saved.get(), blob.data(), blob.size(), nullptr) == OBC_OK);

  const auto created = test::fail_each_allocation([&](const obc_host& host) {
    obc_projected_gradient* solver = nullptr;
    const obc_status status =
        obc_projected_gradient_create(&fixture.problem, nullptr, fixture.start.data(), &host, &solver, nullptr);
    obc_projected_gradient_destroy(solver);
    return status;
  });
  CHECK(created.problem == "");
  CHECK(created.runs > 20);
  const auto loaded = test::fail_each_allocation([&](const obc_host& host) {
    obc_projected_gradient* solver = nullptr;
    const obc_status status =
        obc_projected_gradient_load(&fixture.problem, blob.data(), blob.size(), &host, &solver, nullptr);
    obc_projected_gradient_destroy(solver);
    return status;
  });
  CHECK(loaded.problem == "");
  const auto minimised = test::fail_each_allocation([&](const obc_host& host) {
    std::array<double, unknowns> x = fixture.start;
    return obc_projected_gradient_minimize(&fixture.problem, nullptr, callback, nullptr, x.data(), nullptr, &host,
                                           nullptr);
  });
  CHECK(minimised.problem == "");
  // All memory is taken at the start: the run itself allocates only the gradient more than create.
  CHECK(minimised.runs <= created.runs + 1);
  const auto projected = test::fail_each_allocation([&](const obc_host& host) {
    std::array<double, unknowns> x;
    return obc_projected_gradient_project(&fixture.problem, fixture.start.data(), x.data(), nullptr, nullptr, &host,
                                          nullptr);
  });
  CHECK(projected.problem == "");
}

TEST_CASE("A host can cancel at any report, and gets its best point") {
  const Fixture fixture;
  const auto outcome = test::cancel_everywhere([&](const obc_host& host) {
    std::array<double, unknowns> x = fixture.start;
    obc_projected_gradient_result result = empty_result();
    const obc_status status = obc_projected_gradient_minimize(&fixture.problem, nullptr, callback, nullptr, x.data(),
                                                              &result, &host, nullptr);
    const bool cancelled = result.stop == OBC_PROJECTED_GRADIENT_CANCELLED;
    // Cancelled in the status if and only if in the result; with a value, x is where it was found.
    if (cancelled != (status == OBC_CANCELLED)) return static_cast<obc_status>(OBC_INTERNAL);
    std::array<double, unknowns> gradient;
    if (!std::isnan(result.value) && evaluate(x.data(), gradient.data()) != result.value)
      return static_cast<obc_status>(OBC_INTERNAL);
    return status;
  });
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 1);
}

TEST_CASE("A callback can stop the run or say that f has no value") {
  const Fixture fixture;
  struct Plan {
    int calls = 0, stop_at = -1, fail_at = -1;
  };
  const obc_projected_gradient_function f = [](const double* x, std::size_t, double* value, double* gradient,
                                               void* user) -> std::int32_t {
    Plan& plan = *static_cast<Plan*>(user);
    const int call = plan.calls++;
    if (call == plan.stop_at) return OBC_PROJECTED_GRADIENT_STOP;
    if (call == plan.fail_at) return OBC_PROJECTED_GRADIENT_FAILED;
    *value = evaluate(x, gradient);
    return OBC_PROJECTED_GRADIENT_CONTINUE;
  };
  Plan stopping{0, 4, -1};
  std::array<double, unknowns> x = fixture.start;
  obc_projected_gradient_result result = empty_result();
  CHECK(obc_projected_gradient_minimize(&fixture.problem, nullptr, f, &stopping, x.data(), &result, nullptr, nullptr) ==
        OBC_OK);
  CHECK(result.stop == OBC_PROJECTED_GRADIENT_CANCELLED);
  CHECK(stopping.calls == 5);
  std::array<double, unknowns> gradient;
  CHECK(evaluate(x.data(), gradient.data()) == result.value);

  // The value that comes with STOP counts, with and without a gradient.
  for (const bool with_gradient : {false, true}) {
    struct Last {
      bool with_gradient;
      int calls;
    } last{with_gradient, 0};
    const obc_projected_gradient_function at_last = [](const double* at, std::size_t, double* value, double* slopes,
                                                       void* user) -> std::int32_t {
      Last& plan = *static_cast<Last*>(user);
      *value = evaluate(at, slopes);
      if (++plan.calls < 3) return OBC_PROJECTED_GRADIENT_CONTINUE;
      *value = -1e6;
      if (!plan.with_gradient) slopes[0] = std::numeric_limits<double>::quiet_NaN();
      return OBC_PROJECTED_GRADIENT_STOP;
    };
    x = fixture.start;
    CHECK(obc_projected_gradient_minimize(&fixture.problem, nullptr, at_last, &last, x.data(), &result, nullptr,
                                          nullptr) == OBC_OK);
    CHECK(result.stop == OBC_PROJECTED_GRADIENT_CANCELLED);
    CHECK(result.value == -1e6);
    CHECK(result.evaluations == 3);
  }

  Plan failing{0, -1, 3};
  x = fixture.start;
  CHECK(obc_projected_gradient_minimize(&fixture.problem, nullptr, f, &failing, x.data(), &result, nullptr, nullptr) ==
        OBC_OK);
  CHECK(result.stop == OBC_PROJECTED_GRADIENT_CONVERGED);
  CHECK(result.failed_evaluations == 1);
}

TEST_CASE("A gradient is checked through C: entries, failing allocations, a host that cancels, arguments") {
  const Fixture fixture;
  const obc_projected_gradient_function wrong = [](const double* x, std::size_t, double* value, double* gradient,
                                                   void*) -> std::int32_t {
    *value = evaluate(x, gradient);
    gradient[3] += 1;
    return OBC_PROJECTED_GRADIENT_CONTINUE;
  };
  obc_projected_gradient_check check{};
  check.struct_size = sizeof check;
  const double* x = fixture.start.data();
  CHECK(obc_projected_gradient_check_gradient(&fixture.problem, callback, nullptr, x, &check, nullptr, nullptr) ==
        OBC_OK);
  CHECK(check.agrees == 1);
  CHECK(check.compared == unknowns);
  CHECK(obc_projected_gradient_check_gradient(&fixture.problem, wrong, nullptr, x, &check, nullptr, nullptr) == OBC_OK);
  CHECK(check.agrees == 0);
  CHECK(check.worst == 3);
  CHECK(check.told - check.difference == doctest::Approx(1));
  const auto run = [&](const obc_host& host) {
    obc_projected_gradient_check result{};
    result.struct_size = sizeof result;
    return obc_projected_gradient_check_gradient(&fixture.problem, callback, nullptr, x, &result, &host, nullptr);
  };
  CHECK(test::fail_each_allocation(run).problem == "");
  CHECK(test::cancel_everywhere(run).problem == "");
  const obc_projected_gradient_function stop = [](const double*, std::size_t, double*, double*, void*) -> std::int32_t {
    return OBC_PROJECTED_GRADIENT_STOP;
  };
  CHECK(obc_projected_gradient_check_gradient(&fixture.problem, stop, nullptr, x, &check, nullptr, nullptr) ==
        OBC_CANCELLED);
  const obc_projected_gradient_function failed = [](const double*, std::size_t, double*, double*,
                                                    void*) -> std::int32_t { return OBC_PROJECTED_GRADIENT_FAILED; };
  for (const auto status :
       {obc_projected_gradient_check_gradient(nullptr, callback, nullptr, x, &check, nullptr, nullptr),
        obc_projected_gradient_check_gradient(&fixture.problem, nullptr, nullptr, x, &check, nullptr, nullptr),
        obc_projected_gradient_check_gradient(&fixture.problem, callback, nullptr, nullptr, &check, nullptr, nullptr),
        obc_projected_gradient_check_gradient(&fixture.problem, callback, nullptr, x, nullptr, nullptr, nullptr),
        obc_projected_gradient_check_gradient(&fixture.problem, failed, nullptr, x, &check, nullptr, nullptr)})
    CHECK(status == OBC_INVALID_ARGUMENT);
}

TEST_CASE("Infeasible constraints come with a certificate") {
  Fixture fixture;
  fixture.b[0] = 100;  // x_0 + 2 x_1 - x_2 + x_5 is at most 1 + 4 + 1 + 1.5
  const Handle solver = create(fixture);
  std::array<double, 2> certificate;
  CHECK(obc_projected_gradient_certificate(solver.get(), certificate.data(), nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_projected_gradient_step(solver.get(), nullptr) == OBC_PROJECTED_GRADIENT_DONE);
  obc_projected_gradient_result result = empty_result();
  REQUIRE(obc_projected_gradient_get_result(solver.get(), &result, nullptr, nullptr) == OBC_OK);
  CHECK(result.stop == OBC_PROJECTED_GRADIENT_INFEASIBLE);
  REQUIRE(obc_projected_gradient_certificate(solver.get(), certificate.data(), nullptr) == OBC_OK);
  const auto proves = [&] {
    std::array<double, unknowns> slope{};
    for (std::size_t i = 0; i < 2; ++i) {
      for (std::size_t k = fixture.row_start[i]; k < fixture.row_start[i + 1]; ++k)
        slope[fixture.column[k]] += fixture.value[k] * certificate[i];
    }
    double largest = 0;
    for (std::size_t j = 0; j < unknowns; ++j)
      largest += slope[j] * (slope[j] > 0 ? fixture.upper[j] : fixture.lower[j]);
    return largest < certificate[0] * fixture.b[0] + certificate[1] * fixture.b[1];
  };
  CHECK(proves());
  std::array<double, unknowns> x;
  certificate = {};
  CHECK(obc_projected_gradient_project(&fixture.problem, fixture.start.data(), x.data(), certificate.data(), &result,
                                       nullptr, nullptr) == OBC_OK);
  CHECK(result.stop == OBC_PROJECTED_GRADIENT_INFEASIBLE);
  CHECK(proves());
}

TEST_CASE("The projection alone is clip(y + A't)") {
  const Fixture fixture;
  const std::array<double, unknowns> y{3, -2, 0.5, 7, -7, 0.25};
  std::array<double, unknowns> x;
  std::array<double, 2> t;
  obc_projected_gradient_result result = empty_result();
  REQUIRE(obc_projected_gradient_project(&fixture.problem, y.data(), x.data(), t.data(), &result, nullptr, nullptr) ==
          OBC_OK);
  CHECK(result.stop == OBC_PROJECTED_GRADIENT_CONVERGED);
  CHECK(result.equality_residual < 1e-14);
  std::array<double, unknowns> moved = y;
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t k = fixture.row_start[i]; k < fixture.row_start[i + 1]; ++k)
      moved[fixture.column[k]] += fixture.value[k] * t[i];
  }
  for (std::size_t j = 0; j < unknowns; ++j) {
    CHECK(x[j] == doctest::Approx(std::clamp(moved[j], fixture.lower[j], fixture.upper[j])).epsilon(1e-12));
  }
}

TEST_CASE("Arguments that cannot be are refused") {
  const Fixture fixture;
  obc_projected_gradient* solver = nullptr;
  obc_error error;
  const auto refused = [&](const obc_projected_gradient_problem& problem, const obc_projected_gradient_options* options,
                           const double* start) {
    solver = reinterpret_cast<obc_projected_gradient*>(&error);
    return obc_projected_gradient_create(&problem, options, start, nullptr, &solver, &error) == OBC_INVALID_ARGUMENT &&
           solver == nullptr && error.message[0] != '\0';
  };
  obc_projected_gradient_problem problem = fixture.problem;
  problem.struct_size = 0;
  CHECK(refused(problem, nullptr, fixture.start.data()));
  problem = fixture.problem;
  problem.n = 0;
  CHECK(refused(problem, nullptr, fixture.start.data()));
  problem = fixture.problem;
  problem.column = nullptr;
  CHECK(refused(problem, nullptr, fixture.start.data()));
  problem = fixture.problem;
  std::array<double, unknowns> crossed = fixture.upper;
  crossed[2] = -3;
  problem.upper = crossed.data();
  CHECK(refused(problem, nullptr, fixture.start.data()));
  std::array<double, unknowns> start = fixture.start;
  start[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(refused(fixture.problem, nullptr, start.data()));
  obc_projected_gradient_options options;
  for (const int which : {0, 1, 2, 3, 4, 5}) {
    obc_projected_gradient_options_init(&options, sizeof options);
    if (which == 0) options.method = 2;
    if (which == 1) options.line_search = -1;
    if (which == 2) options.memory = 0;
    if (which == 3) options.history = 0;
    if (which == 4) options.average_weight = 1.5;
    if (which == 5) options.gradient_tolerance = std::numeric_limits<double>::quiet_NaN();
    CHECK(refused(fixture.problem, &options, fixture.start.data()));
  }
  CHECK(obc_projected_gradient_create(nullptr, nullptr, start.data(), nullptr, &solver, nullptr) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_projected_gradient_create(&fixture.problem, nullptr, nullptr, nullptr, &solver, nullptr) ==
        OBC_INVALID_ARGUMENT);
  CHECK(obc_projected_gradient_step(nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_projected_gradient_tell(nullptr, 0, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_projected_gradient_get_result(nullptr, nullptr, nullptr, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_projected_gradient_save_size(nullptr) == 0);
  obc_projected_gradient_destroy(nullptr);
}

TEST_CASE("A problem of zeros with its size is the one that init fills") {
  const std::array<double, 2> lower{1.5, -10};
  obc_projected_gradient_problem written{};
  written.struct_size = sizeof written;
  written.n = 2;
  written.lower = lower.data();
  obc_projected_gradient_problem filled;
  obc_projected_gradient_problem_init(&filled, sizeof filled);
  filled.n = 2;
  filled.lower = lower.data();
  const obc_projected_gradient_function f = [](const double* x, size_t, double* value, double* gradient,
                                               void*) -> int32_t {
    const double away = x[1] - x[0];
    *value = (x[0] - 1) * (x[0] - 1) + 10 * away * away;
    gradient[0] = 2 * (x[0] - 1) - 20 * away;
    gradient[1] = 20 * away;
    return OBC_PROJECTED_GRADIENT_CONTINUE;
  };
  std::array<double, 2> y{2, 3}, z = y;
  CHECK(obc_projected_gradient_minimize(&written, nullptr, f, nullptr, y.data(), nullptr, nullptr, nullptr) == OBC_OK);
  CHECK(obc_projected_gradient_minimize(&filled, nullptr, f, nullptr, z.data(), nullptr, nullptr, nullptr) == OBC_OK);
  CHECK(y == z);
  CHECK(y[0] == 1.5);
  CHECK(std::abs(y[1] - 1.5) < 1e-7);
}

TEST_CASE("Every stop has a name of its own") {
  CHECK(test::names_differ(obc_projected_gradient_stop_name, OBC_PROJECTED_GRADIENT_PROJECTION_FAILED));
  CHECK(obc_projected_gradient_version() >= 100);
}

// The second half of the next test.
TEST_CASE("A run goes on from a file" * doctest::skip(!test::in_second_process())) {
  const Fixture fixture;
  const test::Bytes blob = test::blob_of_first_process();
  obc_projected_gradient* solver = nullptr;
  REQUIRE(obc_projected_gradient_load(&fixture.problem, blob.data(), blob.size(), nullptr, &solver, nullptr) == OBC_OK);
  const Handle handle(solver);
  drive(solver);
  const std::array<double, unknowns> x = best(solver);
  test::answer_first_process(x.data(), sizeof x);
}

TEST_CASE("Saved at each evaluation, a run goes on in a new process with the same bits") {
  const Fixture fixture;
  const Handle whole = create(fixture);
  drive(whole.get());
  obc_projected_gradient_result result = empty_result();
  REQUIRE(obc_projected_gradient_get_result(whole.get(), &result, nullptr, nullptr) == OBC_OK);
  const std::array<double, unknowns> expected = best(whole.get());
  REQUIRE(result.evaluations > 5);
  for (int evaluation = 0; evaluation < static_cast<int>(result.evaluations); ++evaluation) {
    const Handle solver = create(fixture);
    drive(solver.get(), evaluation);
    test::Bytes blob(obc_projected_gradient_save_size(solver.get()));
    obc_error error;
    REQUIRE(obc_projected_gradient_save(solver.get(), blob.data(), blob.size() - 1, &error) == OBC_INVALID_ARGUMENT);
    REQUIRE(obc_projected_gradient_save(solver.get(), blob.data(), blob.size(), &error) == OBC_OK);
    const test::Bytes end = test::in_new_process("A run goes on from a file", blob);
    REQUIRE(end.size() == sizeof expected);
    CHECK(std::memcmp(end.data(), expected.data(), sizeof expected) == 0);
  }
}
