// Unknowns of unlike units: the scale that is chosen where the caller gives none.
#include <doctest/doctest.h>

#include <random>

#include "runs.h"

using namespace orbicube;
using namespace orbicube::test;

namespace {

// Rosenbrock's chain of unknowns x_i with unit_i, from the start (-1.2, 1, -1.2, ...).
Case chain(const std::vector<double>& unit, bool with_residuals) {
  Case c{"chain", {}, 2 * (unit.size() - 1), {}, 0, {}, {}, {}, {}};
  for (std::size_t i = 0; i < unit.size(); ++i)
    c.start.push_back((i % 2 == 0 ? -1.2 : 1.0) * unit[i]);
  c.function = [unit](std::span<const double> x) {
    std::vector<double> r;
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      const double u = x[i] / unit[i], next = x[i + 1] / unit[i + 1];
      r.push_back(10 * (next - u * u));
      r.push_back(1 - u);
    }
    return r;
  };
  return with_residuals ? c : as_scalar(c);
}

void box(Case& c, const std::vector<double>& unit) {
  for (const double u : unit) {
    c.lower.push_back(-2 * u);
    c.upper.push_back(2 * u);
  }
}

// The chain has a second minimum near (-1, 1, ..., 1) from n = 4 on.
bool at_a_minimum(double value) {
  return value < 1e-10 || (value > 3.5 && value < 4.2);
}

std::vector<std::vector<double>> units() {
  std::vector<std::vector<double>> all = {{1e-4, 1e4}, {1e4, 1e-4}, {1e-8, 1e8}, {1e-6, 1e-6}, {1, 50}, {1, 1e-3, 1e3}};
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> exponent(-8, 8);
  for (const std::size_t n : {3U, 5U, 10U}) {
    std::vector<double> unit(n);
    for (double& u : unit)
      u = std::pow(10.0, exponent(random));
    all.push_back(unit);
  }
  return all;
}

}  // namespace

TEST_CASE("Unknowns of unlike units in boxes are minimized like those of one unit") {
  for (const bool with_residuals : {false, true}) {
    for (const auto& unit : units()) {
      Case c = chain(unit, with_residuals), alike = chain(std::vector<double>(unit.size(), 1.0), with_residuals);
      box(c, unit);
      box(alike, std::vector<double>(unit.size(), 1.0));
      const Run end = run(c), same = run(alike);
      CAPTURE(unit.size());
      CAPTURE(unit[0]);
      CHECK(at_a_minimum(end.result.value));
      // The paths differ by the first radius.
      CHECK(end.result.evaluations <= 2 * same.result.evaluations + 40);
      bool inside = true;
      for (const auto& x : end.asked)
        inside = inside && within_bounds(c, x);
      CHECK(inside);
    }
  }
}

TEST_CASE("A start at its bounds, one bound and no bounds do not keep unlike units from a minimum") {
  for (const bool with_residuals : {false, true}) {
    for (const auto& unit : units()) {
      if (unit[0] == unit[1]) continue;  // without boxes nothing says that 1e-6 is not zero
      Case at_bound = chain(unit, with_residuals), half = at_bound, free = at_bound;
      box(at_bound, unit);
      at_bound.start[0] = at_bound.lower[0];
      for (const double u : unit)
        half.lower.push_back(-2 * u);
      half.upper.assign(unit.size(), infinity);
      CAPTURE(unit.size());
      CAPTURE(unit[0]);
      CHECK(at_a_minimum(run(at_bound).result.value));
      CHECK(at_a_minimum(run(half).result.value));
      CHECK(at_a_minimum(run(free).result.value));
    }
  }
}

TEST_CASE("Boxes that are alike, and a scale that is given, leave lengths as they are") {
  Case c = as_scalar(rosenbrock());
  box(c, {1, 2});
  Case scaled = c;
  scaled.scale = {1, 1};
  const Run alike = run(c), given = run(scaled);
  REQUIRE(alike.asked.size() == given.asked.size());
  for (std::size_t k = 0; k < alike.asked.size(); ++k)
    CHECK(alike.asked[k] == given.asked[k]);
  // The first step of the cross is a tenth of max(1, |x0|) as before.
  CHECK(alike.asked[1][0] == -1.2 + 0.12);
}

TEST_CASE("A given scale far from the lengths by which f bends does not end a run far from the minimum as converged") {
  std::size_t far = 0;
  for (const bool with_residuals : {false, true}) {
    for (const std::vector<double>& scale : std::vector<std::vector<double>>{
             {1, 1}, {1, 1e4}, {1e-2, 1e2}, {1e-4, 1}, {1e-4, 1e4}, {1e-2, 1}, {1e-4, 1e-4}}) {
      Case c = chain({1e-4, 1e4}, with_residuals);
      box(c, {1e-4, 1e4});
      c.scale = scale;
      const Run end = run(c);
      CAPTURE(scale[0]);
      CAPTURE(scale[1]);
      CAPTURE(end.result.value);
      if (end.result.value > 1e-6) {
        ++far;
        CHECK(end.result.stop != trust_region::Stop::converged);
      }
      if (scale[1] == 1e8 * scale[0]) CHECK(end.result.stop == trust_region::Stop::converged);
    }
  }
  CHECK(far > 0);
}

TEST_CASE("A first radius that is given is a length of the unknown in the narrowest box") {
  Case c = chain({1e-3, 1e3}, false);
  box(c, {1e-3, 1e3});
  Options options;
  options.radius_begin = 4e-4;
  options.radius_end = 4e-11;
  const Run end = run(c, options);
  CHECK(std::abs(end.asked[1][0] - end.asked[0][0]) == doctest::Approx(4e-4));
  CHECK(std::abs(end.asked[2][1] - end.asked[0][1]) == doctest::Approx(4e2));
  CHECK(end.result.value < 1e-10);
}

TEST_CASE("A bound as wide as an infinity, and a start that is zero but for rounding, choose no scale") {
  Case c = as_scalar(rosenbrock());
  const Run free = run(c);
  c.lower = {-1e30, -1e30};
  c.upper = {1e30, 1e30};
  CHECK(run(c).result.value < 1e-12);
  c = as_scalar(rosenbrock());
  c.start = {1e-17, 1};
  const Run end = run(c);
  CHECK(std::abs(end.asked[1][0]) == doctest::Approx(0.1));
  CHECK(end.result.value < 1e-12);
  CHECK(free.result.value < 1e-12);
}
