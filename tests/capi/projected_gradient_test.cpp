// The C functions of projected_gradient: what they promise about arguments, memory, cancelling, callbacks and resuming.
// How well the methods do is tested in tests/projected_gradient/.
#include "orbicube/projected_gradient.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <thread>
#include <vector>

#include "failing_allocations.h"

using namespace orbicube;

namespace {

constexpr std::size_t unknowns = 12;
using Point = std::array<double, unknowns>;

// min sum (i + 1) (x_i - 0.3 i)^4 + x_i x_(i+1)   subject to   sum x = 4, x_0 - x_11 = 0, 0 <= x <= 1.
struct Task {
  Point lower{};
  Point upper{};
  Point start{};
  std::array<std::size_t, 3> row_start{0, unknowns, unknowns + 2};
  std::array<std::uint32_t, unknowns + 2> column{};
  std::array<double, unknowns + 2> value{};
  std::array<double, 2> b{4, 0};
  obc_projected_gradient_problem problem{};

  Task() {
    upper.fill(1);
    value.fill(1);
    for (std::uint32_t i = 0; i < unknowns; ++i)
      column[i] = i;
    column[unknowns] = 0;
    column[unknowns + 1] = unknowns - 1;
    value[unknowns + 1] = -1;
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
  Task(const Task&) = delete;
};

double objective(const double* x, double* gradient) {
  double sum = 0;
  for (std::size_t i = 0; i < unknowns; ++i) {
    const double away = x[i] - 0.3 * static_cast<double>(i);
    const double weight = static_cast<double>(i + 1);
    sum += weight * away * away * away * away;
    gradient[i] = 4 * weight * away * away * away;
  }
  for (std::size_t i = 0; i + 1 < unknowns; ++i) {
    sum += x[i] * x[i + 1];
    gradient[i] += x[i + 1];
    gradient[i + 1] += x[i];
  }
  return sum;
}

std::int32_t callback(const double* x, std::size_t, double* value, double* gradient, void*) {
  *value = objective(x, gradient);
  return OBC_PROJECTED_GRADIENT_CONTINUE;
}

obc_status minimize(const Task& task, const obc_host* host, Point& x, obc_projected_gradient_function f = callback,
                    void* user = nullptr, obc_projected_gradient_result* result = nullptr) {
  x = task.start;
  return obc_projected_gradient_minimize(&task.problem, nullptr, f, user, x.data(), result, host, nullptr);
}

// Answers at most `most` requests of a solver; whether it is done.
bool drive(obc_projected_gradient* solver, std::size_t most) {
  const double* x = nullptr;
  Point gradient;
  while (true) {
    const std::int32_t request = obc_projected_gradient_step(solver, &x);
    REQUIRE(request > 0);
    if (request == OBC_PROJECTED_GRADIENT_DONE) return true;
    if (request != OBC_PROJECTED_GRADIENT_NEED_FG) continue;
    if (most-- == 0) return false;
    const double value = objective(x, gradient.data());
    REQUIRE(obc_projected_gradient_tell(solver, value, gradient.data(), nullptr) == OBC_OK);
  }
}

bool same_bits(const Point& a, const Point& b) {
  return std::memcmp(a.data(), b.data(), sizeof a) == 0;
}

}  // namespace

TEST_CASE("Wrong arguments are answered, not followed") {
  const Task task;
  obc_projected_gradient* solver = nullptr;
  obc_projected_gradient_options options;
  obc_error error;
  const auto created_with = [&](const obc_projected_gradient_problem* problem, const double* start) {
    return obc_projected_gradient_create(problem, &options, start, nullptr, &solver, &error);
  };
  REQUIRE(obc_projected_gradient_options_init(&options, sizeof options) == OBC_OK);
  CHECK(obc_projected_gradient_options_init(nullptr, sizeof options) == OBC_INVALID_ARGUMENT);
  CHECK(created_with(nullptr, task.start.data()) == OBC_INVALID_ARGUMENT);
  CHECK(created_with(&task.problem, nullptr) == OBC_INVALID_ARGUMENT);
  CHECK(obc_projected_gradient_create(&task.problem, nullptr, task.start.data(), nullptr, nullptr, &error) ==
        OBC_INVALID_ARGUMENT);

  Task wrong;
  wrong.column[3] = unknowns;
  CHECK(created_with(&wrong.problem, wrong.start.data()) == OBC_INVALID_ARGUMENT);
  CHECK(std::strlen(error.message) > 0);
  wrong.column[3] = 3;
  wrong.row_start[1] = 100;
  CHECK(created_with(&wrong.problem, wrong.start.data()) == OBC_INVALID_ARGUMENT);
  wrong.row_start[1] = unknowns;
  wrong.start[5] = std::numeric_limits<double>::quiet_NaN();
  CHECK(created_with(&wrong.problem, wrong.start.data()) == OBC_INVALID_ARGUMENT);
  wrong.start[5] = 0;
  wrong.lower[2] = 2;
  CHECK(created_with(&wrong.problem, wrong.start.data()) == OBC_INVALID_ARGUMENT);
  options.method = 1000;
  CHECK(created_with(&task.problem, task.start.data()) == OBC_INVALID_ARGUMENT);

  CHECK(obc_projected_gradient_step(nullptr, nullptr) < 0);
  CHECK(obc_projected_gradient_tell(nullptr, 0, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_projected_gradient_get_result(nullptr, nullptr, nullptr, &error) == OBC_INVALID_ARGUMENT);
  CHECK(obc_projected_gradient_save(nullptr, nullptr, 0, &error) == OBC_INVALID_ARGUMENT);
  obc_projected_gradient_destroy(nullptr);
  CHECK(obc_projected_gradient_stop_name(-5) != nullptr);
}

TEST_CASE("Each allocation fails in turn and nothing is leaked") {
  const Task task;
  Point x;
  const test::Outcome outcome =
      test::fail_each_allocation([&](const obc_host& host) { return minimize(task, &host, x); });
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 5);

  obc_projected_gradient* solver = nullptr;
  REQUIRE(obc_projected_gradient_create(&task.problem, nullptr, task.start.data(), nullptr, &solver, nullptr) ==
          OBC_OK);
  REQUIRE_FALSE(drive(solver, 3));
  std::vector<unsigned char> blob(obc_projected_gradient_save_size(solver));
  CHECK(test::fail_each_allocation([&](const obc_host&) {
          return obc_projected_gradient_save(solver, blob.data(), blob.size(), nullptr);
        }).problem == "");
  obc_projected_gradient_destroy(solver);
  CHECK(test::fail_each_allocation([&](const obc_host& host) {
          obc_projected_gradient* loaded = nullptr;
          const obc_status status =
              obc_projected_gradient_load(&task.problem, blob.data(), blob.size(), &host, &loaded, nullptr);
          obc_projected_gradient_destroy(loaded);
          return status;
        }).problem == "");
  CHECK(test::fail_each_allocation([&](const obc_host& host) {
          return obc_projected_gradient_project(&task.problem, task.start.data(), x.data(), nullptr, nullptr, &host,
                                                nullptr);
        }).problem == "");
}

TEST_CASE("A solver allocates in create only") {
  const Task task;
  for (const std::int32_t method : {OBC_PROJECTED_GRADIENT_FACE, OBC_PROJECTED_GRADIENT_SEED}) {
    obc_projected_gradient_options options;
    obc_projected_gradient_options_init(&options, sizeof options);
    options.method = method;
    obc_projected_gradient* solver = nullptr;
    REQUIRE(obc_projected_gradient_create(&task.problem, &options, task.start.data(), nullptr, &solver, nullptr) ==
            OBC_OK);
    const std::size_t before = test::allocation_count();
    const double* x = nullptr;
    Point gradient;
    std::int32_t request = 0;
    while ((request = obc_projected_gradient_step(solver, &x)) > 0 && request != OBC_PROJECTED_GRADIENT_DONE) {
      if (request != OBC_PROJECTED_GRADIENT_NEED_FG) continue;
      const double value = objective(x, gradient.data());
      obc_projected_gradient_tell(solver, value, gradient.data(), nullptr);
    }
    CHECK(test::allocation_count() == before);
    CHECK(request == OBC_PROJECTED_GRADIENT_DONE);
    obc_projected_gradient_destroy(solver);
  }
}

TEST_CASE("A run is cancelled at each of its reports") {
  const Task task;
  Point x;
  const test::Outcome outcome = test::cancel_everywhere([&](const obc_host& host) { return minimize(task, &host, x); });
  CHECK(outcome.problem == "");
  CHECK(outcome.runs > 1);
}

TEST_CASE("A callback that fails at any evaluation, in any way, ends in a stated outcome") {
  struct Script {
    std::size_t count = 0;
    std::size_t failing = 0;
    int way = 0;
  };
  const auto failing = [](const double* x, std::size_t, double* value, double* gradient, void* user) -> std::int32_t {
    auto& script = *static_cast<Script*>(user);
    *value = objective(x, gradient);
    if (script.count++ != script.failing) return OBC_PROJECTED_GRADIENT_CONTINUE;
    if (script.way == 0) *value = std::numeric_limits<double>::quiet_NaN();
    if (script.way == 1) gradient[unknowns - 1] = std::numeric_limits<double>::infinity();
    return script.way == 2 ? OBC_PROJECTED_GRADIENT_FAILED : OBC_PROJECTED_GRADIENT_CONTINUE;
  };
  const Task task;
  Point clean;
  obc_projected_gradient_result result{};
  result.struct_size = sizeof result;
  REQUIRE(minimize(task, nullptr, clean, callback, nullptr, &result) == OBC_OK);
  REQUIRE(result.stop == OBC_PROJECTED_GRADIENT_CONVERGED);
  const std::size_t evaluations = result.evaluations;
  const double clean_value = result.value;
  for (int way = 0; way < 3; ++way) {
    for (std::size_t at = 0; at < evaluations; ++at) {
      CAPTURE(way);
      CAPTURE(at);
      Script script{0, at, way};
      Point x;
      REQUIRE(minimize(task, nullptr, x, failing, &script, &result) == OBC_OK);
      CHECK(result.failed_evaluations == 1);
      if (at == 0) {
        CHECK(result.stop == OBC_PROJECTED_GRADIENT_EVALUATION_FAILED);
        continue;
      }
      CHECK((result.stop == OBC_PROJECTED_GRADIENT_CONVERGED || result.stop == OBC_PROJECTED_GRADIENT_STALLED));
      CHECK(std::all_of(x.begin(), x.end(), [](double entry) { return entry >= 0 && entry <= 1; }));
      // Both are stationary to 1e-8 within a set of diameter 4, so the values agree to about 4e-8, and they are near
      // 1e3.
      CHECK(result.value == doctest::Approx(clean_value).epsilon(1e-10));
    }
  }
}

TEST_CASE("A callback stops the run and the best point so far is handed out") {
  const auto stopping = [](const double* x, std::size_t, double* value, double* gradient, void* user) -> std::int32_t {
    *value = objective(x, gradient);
    return --*static_cast<int*>(user) == 0 ? OBC_PROJECTED_GRADIENT_STOP : OBC_PROJECTED_GRADIENT_CONTINUE;
  };
  const Task task;
  int left = 4;
  Point x;
  Point gradient;
  obc_projected_gradient_result result{};
  result.struct_size = sizeof result;
  REQUIRE(minimize(task, nullptr, x, stopping, &left, &result) == OBC_OK);
  CHECK(result.stop == OBC_PROJECTED_GRADIENT_CANCELLED);
  CHECK(result.value == objective(x.data(), gradient.data()));
}

TEST_CASE("A run saved after any evaluation goes on with the same bits, and damaged bytes are refused") {
  const Task task;
  Point whole;
  REQUIRE(minimize(task, nullptr, whole) == OBC_OK);
  for (std::size_t at = 0;; ++at) {
    obc_projected_gradient* first = nullptr;
    obc_projected_gradient* second = nullptr;
    REQUIRE(obc_projected_gradient_create(&task.problem, nullptr, task.start.data(), nullptr, &first, nullptr) ==
            OBC_OK);
    const bool done = drive(first, at);
    std::vector<unsigned char> blob(obc_projected_gradient_save_size(first));
    REQUIRE(obc_projected_gradient_save(first, blob.data(), blob.size(), nullptr) == OBC_OK);
    CHECK(obc_projected_gradient_save(first, blob.data(), blob.size() - 1, nullptr) == OBC_INVALID_ARGUMENT);
    obc_projected_gradient_destroy(first);
    REQUIRE(obc_projected_gradient_load(&task.problem, blob.data(), blob.size(), nullptr, &second, nullptr) == OBC_OK);
    REQUIRE(drive(second, 100000));
    Point x;
    REQUIRE(obc_projected_gradient_get_result(second, nullptr, x.data(), nullptr) == OBC_OK);
    CHECK(same_bits(x, whole));
    obc_projected_gradient_destroy(second);
    if (!done) continue;
    for (std::size_t size = 0; size < blob.size(); size += 7) {
      CHECK(obc_projected_gradient_load(&task.problem, blob.data(), size, nullptr, &second, nullptr) ==
            OBC_MALFORMED_FILE);
    }
    blob[blob.size() / 2] ^= 0x10U;
    CHECK(obc_projected_gradient_load(&task.problem, blob.data(), blob.size(), nullptr, &second, nullptr) ==
          OBC_MALFORMED_FILE);
    break;
  }
}

TEST_CASE("64 solvers on threads at once give the bits of one alone") {
  const Task task;
  Point alone;
  REQUIRE(minimize(task, nullptr, alone) == OBC_OK);
  std::atomic<int> equal{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 64; ++i) {
    threads.emplace_back([&] {
      Point x;
      if (minimize(task, nullptr, x) == OBC_OK && same_bits(x, alone)) ++equal;
    });
  }
  for (std::thread& thread : threads)
    thread.join();
  CHECK(equal == 64);
}
