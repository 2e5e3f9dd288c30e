// The trust-region step: optimality conditions without bounds, feasibility and descent with them.
#include "trust_region/quadratic_step.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "trust_region/dense.h"

using namespace orbicube;
using trust_region::QuadraticStep;

namespace {

struct Quadratic {
  std::size_t n;
  std::vector<double> gradient, matrix;

  double value(const std::vector<double>& s) const {
    return trust_region::dot(gradient.data(), s.data(), n) +
           0.5 * trust_region::quadratic_form(matrix.data(), n, s.data());
  }
};

Quadratic random_quadratic(std::size_t n, double shift, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Quadratic q{n, std::vector<double>(n), std::vector<double>(n * n)};
  for (std::size_t i = 0; i < n; ++i) {
    q.gradient[i] = normal(random);
    for (std::size_t k = 0; k <= i; ++k)
      q.matrix[i * n + k] = q.matrix[k * n + i] = normal(random);
    q.matrix[i * n + i] += shift;
  }
  return q;
}

// More and Sorensen: (B + t I) s = -g with t >= 0, t = 0 inside the ball, and B + t I positive semidefinite.
void check_optimal(const Quadratic& q, const std::vector<double>& s, double radius, double tolerance) {
  const std::size_t n = q.n;
  const double length = trust_region::norm(s.data(), n);
  CHECK(length <= radius * (1 + 1e-12));
  std::vector<double> residual(n);
  for (std::size_t i = 0; i < n; ++i)
    residual[i] = q.gradient[i] + trust_region::dot(q.matrix.data() + i * n, s.data(), n);
  const double t = -trust_region::dot(residual.data(), s.data(), n) / (length * length);
  const double scale = trust_region::norm(q.matrix.data(), n * n) * radius + trust_region::norm(q.gradient.data(), n);
  for (std::size_t i = 0; i < n; ++i)
    CHECK(std::abs(residual[i] + t * s[i]) < tolerance * scale);
  CHECK(t > -tolerance * scale / radius);
  if (length < radius * (1 - 1e-8)) CHECK(std::abs(t) < tolerance * scale / radius);
  // Cholesky of B + t I, raised by the tolerance.
  std::vector<double> a = q.matrix;
  for (std::size_t i = 0; i < n; ++i)
    a[i * n + i] += t + 10 * tolerance * scale / radius;
  for (std::size_t k = 0; k < n; ++k) {
    REQUIRE(a[k * n + k] > 0);
    for (std::size_t i = k + 1; i < n; ++i) {
      for (std::size_t j = k + 1; j < n; ++j)
        a[i * n + j] -= a[i * n + k] * a[k * n + j] / a[k * n + k];
    }
  }
}

}  // namespace

TEST_CASE("Without bounds a step meets the conditions of More and Sorensen, convex or not") {
  std::mt19937_64 random(1);
  for (const std::size_t n : {1U, 2U, 3U, 7U, 20U}) {
    for (const double shift : {0.0, 5.0, 30.0, -30.0}) {
      for (const double radius : {1e-6, 0.1, 1.0, 100.0}) {
        const Quadratic q = random_quadratic(n, shift, random);
        QuadraticStep step(n, std::pmr::get_default_resource());
        std::vector<double> s(n);
        step.minimise(q.gradient.data(), q.matrix.data(), radius, nullptr, nullptr, s.data());
        CAPTURE(n);
        CAPTURE(shift);
        CAPTURE(radius);
        check_optimal(q, s, radius, 1e-8);  // |s| = radius is solved to 1e-9
      }
    }
  }
}

TEST_CASE("Where the gradient is orthogonal to the lowest eigenvector, the step still goes to the sphere") {
  Quadratic q{3, {0, 1, 0.5}, {-2, 0, 0, 0, 1, 0, 0, 0, 3}};
  QuadraticStep step(3, std::pmr::get_default_resource());
  std::vector<double> s(3);
  step.minimise(q.gradient.data(), q.matrix.data(), 4, nullptr, nullptr, s.data());
  CHECK(trust_region::norm(s.data(), 3) == doctest::Approx(4).epsilon(1e-8));
  CHECK(s[1] == doctest::Approx(-1.0 / 3).epsilon(1e-6));
  CHECK(s[2] == doctest::Approx(-0.1).epsilon(1e-6));
  // A saddle without any slope is left as well.
  q.gradient = {0, 0, 0};
  step.minimise(q.gradient.data(), q.matrix.data(), 1, nullptr, nullptr, s.data());
  CHECK(q.value(s) == doctest::Approx(-1).epsilon(1e-8));
}

TEST_CASE("With bounds a step is within them exactly and goes down at least as far as the best step along an axis") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform;
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t n = 1 + random() % 8;
    const Quadratic q = random_quadratic(n, trial % 3 == 0 ? 10 : 0, random);
    std::vector<double> low(n), high(n), s(n);
    for (std::size_t i = 0; i < n; ++i) {
      low[i] = random() % 4 == 0 ? 0 : -uniform(random);
      high[i] = random() % 4 == 0 ? 0 : uniform(random);
    }
    const double radius = 0.1 + uniform(random);
    QuadraticStep step(n, std::pmr::get_default_resource());
    step.minimise(q.gradient.data(), q.matrix.data(), radius, low.data(), high.data(), s.data());
    CHECK(trust_region::norm(s.data(), n) <= radius * (1 + 1e-8));
    for (std::size_t i = 0; i < n; ++i) {
      CHECK(s[i] >= low[i]);
      CHECK(s[i] <= high[i]);
    }
    CHECK(q.value(s) <= 0);
    if (trial % 3 == 0) {
      // Convex: no small step along a free axis improves by much; only the ball may hold it back.
      for (std::size_t i = 0; i < n; ++i) {
        for (const double change : {-1e-4, 1e-4}) {
          std::vector<double> other = s;
          other[i] += change;
          if (other[i] < low[i] || other[i] > high[i] || trust_region::norm(s.data(), n) > 0.99 * radius) continue;
          if (s[i] == low[i] || s[i] == high[i]) continue;  // fixed unknowns are not freed again
          CHECK(q.value(other) > q.value(s) - 1e-9);
        }
      }
    }
  }
}

TEST_CASE("Matrices of low rank, of any magnitude, are reduced without underflow") {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (const double magnitude : {1.0, 1e-150, 1e100}) {
    for (const std::size_t rank : {1U, 2U}) {
      CAPTURE(magnitude);
      CAPTURE(rank);
      const std::size_t n = 60;
      Quadratic q{n, std::vector<double>(n), std::vector<double>(n * n)};
      for (std::size_t r = 0; r < rank; ++r) {
        std::vector<double> v(n);
        for (double& value : v)
          value = normal(random);
        for (std::size_t i = 0; i < n; ++i) {
          for (std::size_t k = 0; k < n; ++k)
            q.matrix[i * n + k] += (r == 0 ? magnitude : -magnitude) * v[i] * v[k];
        }
      }
      for (double& value : q.gradient)
        value = magnitude * normal(random);
      QuadraticStep step(n, std::pmr::get_default_resource());
      std::vector<double> s(n);
      step.minimise(q.gradient.data(), q.matrix.data(), 0.1, nullptr, nullptr, s.data());
      for (double& value : q.gradient)
        value /= magnitude;
      for (double& value : q.matrix)
        value /= magnitude;
      check_optimal(q, s, 0.1, 1e-8);
    }
  }
}

TEST_CASE("Numbers that are not finite give no step") {
  QuadraticStep step(2, std::pmr::get_default_resource());
  std::vector<double> s(2, 5.0);
  const double nan = std::nan("");
  const std::vector<double> gradient = {1, nan}, matrix = {1, 0, 0, 1};
  step.minimise(gradient.data(), matrix.data(), 1, nullptr, nullptr, s.data());
  CHECK(s == std::vector<double>{0, 0});
}
