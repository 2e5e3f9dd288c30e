// The energy against its definition, and its derivatives against finite differences.
#include "sphere_map/optimization/distortion.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <random>

#include "sphere_map/optimization/vertex_step.h"

using namespace orbicube::sphere_map;

namespace {

struct RandomTriangles {
  std::mt19937_64 engine{11};
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  Vector3 point(double size) { return size * Vector3(number(-1, 1), number(-1, 1), number(-1, 1)); }

  // Counter-clockwise on the sphere, of about the size given.
  std::array<Vector3, 3> spherical(double size) {
    for (;;) {
      const Vector3 centre = point(1).normalized();
      const std::array<Vector3, 3> t = {(centre + point(size)).normalized(), (centre + point(size)).normalized(),
                                        (centre + point(size)).normalized()};
      const SphericalTriangle s(t[0], t[1], t[2]);
      if (s.valid() && s.determinant > 0.05 * size * size) return t;
    }
  }
};

Energy every_term() {
  Energy e;
  e.weights = {.angle = 0.3,
               .area = 0.7,
               .isometric = 0.2,
               .quasi_conformal_1 = 0.4,
               .quasi_conformal_2 = 0.05,
               .quasi_conformal_4 = 0.01};
  e.area_scale = 1.7;
  e.uniform_area = 0.2;
  return e;
}

}  // namespace

TEST_CASE("D, N and d of a triangle are the sums of eq. 3.3 and 3.4") {
  RandomTriangles random;
  for (int i = 0; i < 200; ++i) {
    const auto [p, q, r] = random.spherical(0.5);
    const Vector3 a = random.point(1);
    const Vector3 b = random.point(1);
    const Vector3 c = random.point(1);
    const TriangleShape shape = triangle_shape(a, b, c);
    const SphericalTriangle t(p, q, r);
    const auto cotangent = [](const Vector3& at, const Vector3& x, const Vector3& y) {
      const double angle = std::acos((x - at).normalized().dot((y - at).normalized()));
      return std::cos(angle) / std::sin(angle);
    };
    const double D = cotangent(a, b, c) * (q - r).squaredNorm() + cotangent(b, c, a) * (r - p).squaredNorm() +
                     cotangent(c, a, b) * (p - q).squaredNorm();
    CHECK(t.D(shape) == doctest::Approx(D).epsilon(1e-6));
    CHECK(std::sqrt(t.N) == doctest::Approx((q - p).cross(r - p).norm()));
    CHECK(t.determinant == doctest::Approx(p.dot(q.cross(r))));
    // d is the distance of the closest point of the flat triangle: smallest over a fine grid of its points.
    double nearest = 2;
    const int steps = 60;
    for (int x = 0; x <= steps; ++x) {
      for (int y = 0; x + y <= steps; ++y) {
        nearest = std::min(nearest, (p + (x * (q - p) + y * (r - p)) / steps).norm());
      }
    }
    CHECK(std::sqrt(1 / t.inverse_d_square()) == doctest::Approx(nearest).epsilon(1e-3));
  }
}

TEST_CASE("The isometric and the quasi-conformal distortion terms are what singular values say") {
  // A right triangle with legs 1 and 1, mapped to one with legs s1 and s2 that is small, so that d is nearly 1.
  const double s1 = 3e-3;
  const double s2 = 1e-3;
  const TriangleShape shape = triangle_shape({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const Vector3 p(0, 0, 1);
  const SphericalTriangle t(p, Vector3(s1, 0, 1).normalized(), Vector3(0, s2, 1).normalized());
  Energy e;
  e.weights.isometric = 1;
  // D AT^2 / det^2 = AT (s1^-2 + s2^-2), the inverse part of the symmetric Dirichlet energy, times the area 1/2 ...
  // twice.
  CHECK(triangle_energy(e, shape, t) == doctest::Approx(0.25 * (1 / (s1 * s1) + 1 / (s2 * s2))).epsilon(1e-4));
  e.weights = {.quasi_conformal_2 = 1};
  const double m = 0.5 * (s1 / s2 + s2 / s1);
  CHECK(triangle_energy(e, shape, t) == doctest::Approx(m * m).epsilon(1e-4));
  e.weights = {.quasi_conformal_4 = 1};
  CHECK(triangle_energy(e, shape, t) == doctest::Approx(m * m * m * m).epsilon(1e-4));
}

TEST_CASE("Partial derivatives by D, N and M agree with finite differences") {
  RandomTriangles random;
  const Energy energy = every_term();
  const auto value = [&](const TriangleShape& shape, double D, double N, double M, double d2) {
    // The energy as a function of the three, written out again.
    const Weights& w = energy.weights;
    const double area = shape.area * energy.area_scale;
    const double m = D / (2 * std::sqrt(M));
    return d2 * (w.angle * D + w.area * N / (4 * area) + w.isometric * D * area * area / M +
                 w.quasi_conformal_1 * area * m) +
           energy.uniform_area * (w.quasi_conformal_2 * m * m + w.quasi_conformal_4 * m * m * m * m);
  };
  for (int i = 0; i < 100; ++i) {
    const auto [p, q, r] = random.spherical(0.5);
    const TriangleShape shape = triangle_shape(random.point(1), random.point(1), random.point(1));
    const SphericalTriangle t(p, q, r);
    const EnergyPartials e = energy_partials(energy, shape, t);
    const double D = t.D(shape);
    const double N = t.N;
    const double M = t.determinant * t.determinant;
    const double d2 = t.inverse_d_square();
    CHECK(e.value == doctest::Approx(value(shape, D, N, M, d2)).epsilon(1e-12));
    CHECK(e.value == doctest::Approx(triangle_energy(energy, shape, t)).epsilon(1e-12));
    const double h = 1e-5;
    const auto f = [&](double x, double y, double z) {
      return value(shape, D * (1 + x), N * (1 + y), M * (1 + z), d2);
    };
    CHECK(e.by_D * D == doctest::Approx((f(h, 0, 0) - f(-h, 0, 0)) / (2 * h)).epsilon(1e-6));
    CHECK(e.by_N * N == doctest::Approx((f(0, h, 0) - f(0, -h, 0)) / (2 * h)).epsilon(1e-6));
    CHECK(e.by_M * M == doctest::Approx((f(0, 0, h) - f(0, 0, -h)) / (2 * h)).epsilon(1e-6));
    const double scale = e.value;
    CHECK(e.by_DD * D * D / scale ==
          doctest::Approx((f(h, 0, 0) - 2 * e.value + f(-h, 0, 0)) / (h * h) / scale).epsilon(1e-4));
    CHECK(e.by_MM * M * M / scale ==
          doctest::Approx((f(0, 0, h) - 2 * e.value + f(0, 0, -h)) / (h * h) / scale).epsilon(1e-4));
    CHECK(e.by_DM * D * M / scale ==
          doctest::Approx((f(h, 0, h) - f(h, 0, -h) - f(-h, 0, h) + f(-h, 0, -h)) / (4 * h * h) / scale).epsilon(1e-4));
  }
}

TEST_CASE("The energy grows without bound as a triangle collapses onto an arc, and is infinite beyond") {
  Energy energy;
  energy.weights = {.angle = 0.1, .area = 1, .isometric = 0.05};
  const TriangleShape shape = triangle_shape({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const Vector3 p(1, 0, 0);
  const Vector3 q(0, 1, 0);
  double last = 0;
  for (double height = 0.1; height > 1e-7; height /= 10) {
    // r near the arc from p to q: the flat triangle keeps its area, the determinant vanishes.
    const double value = triangle_energy(energy, shape, SphericalTriangle(p, q, Vector3(1, 1, height).normalized()));
    CHECK(value > 50 * last);
    last = value;
  }
  CHECK(std::isinf(triangle_energy(energy, shape, SphericalTriangle(p, q, Vector3(1, 1, 0).normalized()))));
  CHECK(std::isinf(triangle_energy(energy, shape, SphericalTriangle(p, q, Vector3(1, 1, -1).normalized()))));
}

TEST_CASE("Safely positive triangles stay positive when their coordinates change in the last bits") {
  RandomTriangles random;
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3 p = random.point(1).normalized();
    const double size = std::pow(10.0, random.number(-9, 0));
    const Vector3 q = (p + random.point(size)).normalized();
    const Vector3 r = (p + random.point(1e-15 * random.number(0, 100)) + random.number(0, 1) * (q - p)).normalized();
    if (!safely_positive(p, q, r)) continue;
    ++accepted;
    const auto shaken = [&](Vector3 v) {
      for (double& x : v)
        x = std::nextafter(x, random.number(-1, 1) > 0 ? 2.0 : -2.0);
      return v;
    };
    for (int trial = 0; trial < 10; ++trial) {
      const Vector3 a = shaken(p);
      const Vector3 b = shaken(q);
      const Vector3 c = shaken(r);
      REQUIRE(a.dot((b - a).cross(c - a)) > 0);
    }
  }
  CHECK(accepted > 100);
}
