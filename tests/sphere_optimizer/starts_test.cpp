// Several starts: known least energies that a single start misses, equality with separate runs, limits, and saving.
#include <doctest/doctest.h>

#include "base/error.h"
#include "problems.h"

using namespace orbicube;
using namespace orbicube::test;

namespace {

Options several(std::uint64_t starts, double gradient_tolerance = 1e-8) {
  Options options = with(Method::limited_memory, gradient_tolerance);
  options.starts = starts;
  return options;
}

}  // namespace

TEST_CASE("Charges reach their least known energies from several starts") {
  // Wales and Ulker 2006.
  const std::pair<std::size_t, double> known[] = {{16, 92.911655302}, {27, 287.302615033},  {38, 593.038503566},
                                                  {47, 927.05927068}, {55, 1287.772720783}, {60, 1543.830400976}};
  for (const auto& row : known) {
    const std::size_t count = row.first;
    const double energy = row.second;
    CAPTURE(count);
    const Problem problem = thomson(count, 3);
    const Run end = run(problem, several(30));
    CHECK(end.result.stop == Stop::converged);
    CHECK(std::abs(end.result.value - energy) < 1e-6 * energy);
    CHECK(end.result.starts == 30);
    CHECK(stationarity(problem, end.x) < 1.01e-8);
    std::vector<double> gradient(3 * count);
    CHECK(problem.function(end.x, gradient) == end.result.value);
    CHECK(length_error(problem.shape, end.x) <= 2);
  }
}

TEST_CASE("A run from several starts is the lowest of the runs from each") {
  // With one more start each time, a run does what the shorter one did and then one more.
  const Problem problem = thomson(38, 5);
  double lowest = infinity;
  std::uint64_t evaluations = 0, best_start = 0;
  for (std::uint64_t starts = 1; starts <= 12; ++starts) {
    const Run end = run(problem, several(starts));
    CHECK(end.result.value <= lowest);
    if (end.result.value < lowest) best_start = starts - 1;
    lowest = end.result.value;
    CHECK(end.result.best_start == best_start);
    CHECK(end.result.evaluations > evaluations);
    evaluations = end.result.evaluations;
  }
  CHECK(best_start > 0);
  Options other = several(12);
  other.seed = 1;
  const Run again = run(problem, several(12)), differs = run(problem, other);
  CHECK(again.result.value == lowest);
  CHECK(differs.result.evaluations != evaluations);
}

TEST_CASE("Limits are of the whole run, and the lowest point so far is kept") {
  const Problem problem = thomson(38, 5);
  const Run whole = run(problem, several(6));
  Options options = several(6);
  for (const std::uint64_t budget : {1U, 50U, 150U, 300U, 600U}) {
    options.max_evaluations = budget;
    const Run end = run(problem, options);
    CHECK(end.result.stop == Stop::evaluation_budget);
    CHECK(end.result.evaluations == budget);
    double least = infinity;
    std::vector<double> gradient(problem.start.size());
    for (const auto& x : end.asked)
      least = std::min(least, problem.function(x, gradient));
    CHECK(end.result.value <= least * (1 + 1e-14));
    CHECK(problem.function(end.x, gradient) == end.result.value);
  }
  options.max_evaluations = 100000;
  options.target = whole.result.value * (1 + 1e-9);
  const Run met = run(problem, options);
  CHECK(met.result.value <= options.target);
  CHECK(met.result.starts == whole.result.best_start + 1);
}

TEST_CASE("A start at which the function fails is one of several") {
  Problem problem = thomson(12, 1);
  std::size_t evaluation = 0;
  const Function inner = problem.function;
  problem.function = [&](std::span<const double> x, std::span<double> g) {
    return evaluation++ == 0 ? std::nan("") : inner(x, g);
  };
  const Run end = run(problem, several(2));
  CHECK(end.result.stop == Stop::converged);
  CHECK(end.result.best_start == 1);
  CHECK(std::abs(end.result.value - 49.165253058) < 1e-8);
  CHECK_THROWS_AS(run(problem, several(0)), base::Error);
}

TEST_CASE("Saved at each evaluation of each start, a run goes on with the same bits") {
  for (const Method method : {Method::limited_memory, Method::barzilai_borwein, Method::great_circle}) {
    const Problem problem = thomson(7, 1);
    Options options = several(3, 1e-3);
    options.method = method;
    check_resuming_of(problem, options);
  }
}
