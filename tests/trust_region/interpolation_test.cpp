// Lagrange functions and their updates: what they are defined by, and agreement with a set that is built from scratch.
#include "trust_region/interpolation.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <vector>

#include "trust_region/dense.h"

using namespace orbicube;
using trust_region::Interpolation;

namespace {

// A random set of `count` points around the origin, the first of which is the best.
Interpolation random_set(std::size_t n, std::size_t capacity, std::size_t count, std::mt19937_64& random) {
  Interpolation set(n, std::pmr::get_default_resource());
  set.allocate(capacity, true);
  std::normal_distribution<double> normal;
  std::vector<double> x(n);
  set.resize(count);
  for (std::size_t j = 0; j < count; ++j) {
    for (double& value : x)
      value = normal(random);
    set.place(j, x.data());
  }
  set.set_best(0);
  REQUIRE(set.rebuild());
  return set;
}

double lagrange_at(const Interpolation& set, std::size_t j, const double* x) {
  const std::size_t n = set.dimension();
  std::vector<double> gradient(n), hessian(n * n), coefficients(n + set.size()), d(n);
  set.lagrange_function(j, gradient.data(), hessian.data(), coefficients.data());
  for (std::size_t i = 0; i < n; ++i)
    d[i] = x[i] - set.point(set.best())[i];
  return (j == set.best() ? 1.0 : 0.0) + trust_region::dot(gradient.data(), d.data(), n) +
         0.5 * trust_region::quadratic_form(hessian.data(), n, d.data());
}

double worst_lagrange_error(const Interpolation& set) {
  double worst = 0;
  for (std::size_t j = 0; j < set.size(); ++j) {
    for (std::size_t k = 0; k < set.size(); ++k)
      worst = std::max(worst, std::abs(lagrange_at(set, j, set.point(k)) - (j == k ? 1 : 0)));
  }
  return worst;
}

}  // namespace

TEST_CASE("Lagrange functions are one at their point and zero at the others, for every number of points") {
  std::mt19937_64 random(1);
  for (const std::size_t n : {1U, 2U, 3U, 5U}) {
    const std::size_t full = (n + 1) * (n + 2) / 2;
    for (std::size_t count = n + 1; count <= full; ++count)
      CHECK(worst_lagrange_error(random_set(n, full, count, random)) < 1e-6);  // some of them are badly poised
  }
}

TEST_CASE("Points that come, go and change places leave the inverse as if it were made afresh") {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  const std::size_t n = 4, full = 15;
  Interpolation set = random_set(n, full, 7, random);
  std::vector<double> d(n);
  for (int update = 0; update < 60; ++update) {
    for (double& value : d)
      value = normal(random);
    REQUIRE(set.prepare(d.data()));
    const std::size_t kind = random() % 3;
    if (kind == 0 && set.size() < full) {
      REQUIRE(set.append());
    } else if (kind == 1 && set.size() > n + 2) {
      std::size_t j = random() % set.size();
      if (j == set.best()) j = (j + 1) % set.size();
      // Only where the rest stays poised.
      if (set.alpha(j) < 1e-3) continue;
      REQUIRE(set.remove(j));
    } else {
      std::size_t j = 0;
      for (std::size_t k = 0; k < set.size(); ++k) {
        if (std::abs(set.denominator(k)) > std::abs(set.denominator(j))) j = k;
      }
      if (j == set.best()) continue;
      REQUIRE(set.replace(j));
      if (update % 5 == 0) set.set_best(j);
    }
    CHECK(worst_lagrange_error(set) < 1e-6);
  }
}

TEST_CASE("Moving the base changes neither Lagrange functions nor denominators") {
  std::mt19937_64 random(6);
  const std::size_t n = 4;
  // A random set is badly poised at times: its functions are known to some digits only.
  for (const std::size_t count : {6U, 9U, 15U}) {
    Interpolation set = random_set(n, 15, count, random);
    set.set_best(3);
    const std::vector<double> d = {0.4, -0.1, 0.2, 0.3}, x(n, 0.3);
    std::vector<double> lagrange, denominators;
    REQUIRE(set.prepare(d.data()));
    for (std::size_t j = 0; j < count; ++j) {
      lagrange.push_back(lagrange_at(set, j, x.data()));
      denominators.push_back(set.denominator(j));
    }
    set.move_base(1e-3);
    for (const bool afresh : {false, true}) {
      if (afresh) REQUIRE(set.rebuild());
      for (std::size_t i = 0; i < n; ++i)
        CHECK(set.offset(3)[i] == 0);
      REQUIRE(set.prepare(d.data()));
      for (std::size_t j = 0; j < count; ++j) {
        CHECK(lagrange_at(set, j, x.data()) == doctest::Approx(lagrange[j]).epsilon(1e-5));
        CHECK(set.denominator(j) == doctest::Approx(denominators[j]).epsilon(1e-5));
      }
    }
  }
}

TEST_CASE(
    "The values of a prepared point are those of the Lagrange functions, and its denominators those of determinants") {
  std::mt19937_64 random(3);
  const std::size_t n = 3;
  Interpolation set = random_set(n, 10, 8, random);
  set.set_best(4);  // away from the base
  const std::vector<double> d = {0.3, -0.7, 0.2};
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i)
    x[i] = set.point(4)[i] + d[i];
  REQUIRE(set.prepare(d.data()));
  for (std::size_t j = 0; j < set.size(); ++j)
    CHECK(set.lagrange(j) == doctest::Approx(lagrange_at(set, j, x.data())).epsilon(1e-9));
  // Replacing a point and then putting it back multiplies the determinant by one.
  const std::size_t j = 2;
  const double there = set.denominator(j);
  std::vector<double> back(n);
  for (std::size_t i = 0; i < n; ++i)
    back[i] = set.point(j)[i] - set.point(4)[i];
  REQUIRE(set.replace(j));
  REQUIRE(set.prepare(back.data()));
  CHECK(there * set.denominator(j) == doctest::Approx(1).epsilon(1e-9));
}

TEST_CASE("With points for it, the interpolant of a quadratic is the quadratic; with fewer its Hessian is smaller") {
  std::mt19937_64 random(4);
  const std::size_t n = 4, full = 15;
  std::vector<double> hessian(n * n), slope(n);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < n; ++i) {
    slope[i] = normal(random);
    for (std::size_t k = 0; k <= i; ++k)
      hessian[i * n + k] = hessian[k * n + i] = normal(random);
  }
  double frobenius = trust_region::norm(hessian.data(), n * n);
  for (const std::size_t count : {full, std::size_t{9}}) {
    const Interpolation set = random_set(n, full, count, random);
    std::vector<double> values(count), gradient(n), found(n * n), work(2 * (n + full));
    for (std::size_t j = 0; j < count; ++j) {
      values[j] = 7 + trust_region::dot(slope.data(), set.point(j), n) +
                  0.5 * trust_region::quadratic_form(hessian.data(), n, set.point(j));
    }
    set.interpolant(values.data(), gradient.data(), found.data(), work.data());
    if (count == full) {
      for (std::size_t i = 0; i < n * n; ++i)
        CHECK(found[i] == doctest::Approx(hessian[i]).epsilon(1e-8));
    } else {
      CHECK(trust_region::norm(found.data(), n * n) < frobenius);
      // Orthogonal to what could be added: the Hessian lies in the span of the Lagrange functions' Hessians, and the
      // interpolation is met.
      for (std::size_t j = 0; j < count; ++j) {
        std::vector<double> d(n);
        for (std::size_t i = 0; i < n; ++i)
          d[i] = set.point(j)[i] - set.point(0)[i];
        const double value = values[0] + trust_region::dot(gradient.data(), d.data(), n) +
                             0.5 * trust_region::quadratic_form(found.data(), n, d.data());
        CHECK(value == doctest::Approx(values[j]).epsilon(1e-9));
      }
    }
  }
}

TEST_CASE("Points in a plane are not poised, and that is said") {
  Interpolation set(2, std::pmr::get_default_resource());
  set.allocate(6, true);
  set.resize(4);
  for (std::size_t j = 0; j < 4; ++j) {
    const double x[] = {static_cast<double>(j), 2 * static_cast<double>(j)};
    set.place(j, x);
  }
  set.set_best(0);
  CHECK(!set.rebuild());
}
