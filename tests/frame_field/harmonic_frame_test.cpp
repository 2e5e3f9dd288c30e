// Frames as vectors of nine numbers, and back.
#include "frame_field/smoothing/harmonic_frame.h"

#include <doctest/doctest.h>

#include <numbers>
#include <random>

#include "quaternion/cube_group.h"
#include "solids.h"

using namespace orbicube;
using namespace orbicube::frame_field;
using quaternion::multiply;
using quaternion::symmetric_distance;

namespace {

double distance(const Harmonic& a, const Harmonic& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 9; ++k)
    sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum);
}

// P4(x), which the addition theorem speaks of.
double legendre(double x) {
  return (35 * x * x * x * x - 30 * x * x + 3) / 8;
}

}  // namespace

TEST_CASE("The nine harmonics satisfy the addition theorem") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100; ++i) {
    const Vector u = quaternion::rotate(test::random_rotation(random), {0, 0, 1});
    const Vector v = quaternion::rotate(test::random_rotation(random), {0, 0, 1});
    const double cosine = u.x * v.x + u.y * v.y + u.z * v.z;
    CHECK(std::abs(dot(harmonics_at(u), harmonics_at(v)) - legendre(cosine)) < 1e-14);
  }
}

TEST_CASE("The form's gradient agrees with differences, and the form is its product with the point") {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 50; ++i) {
    Harmonic a;
    for (double& x : a)
      x = normal(random);
    const Vector v{normal(random), normal(random), normal(random)};
    const Vector g = quartic_gradient(a, v);
    // Degree 4: v . gradient = 4 times the value (Euler).
    const double value = dot(a, harmonics_at(v));
    CHECK(g.x * v.x + g.y * v.y + g.z * v.z == doctest::Approx(value).epsilon(1e-12));
    const double h = 1e-5;
    const auto slope = [&](const Vector& d) {
      const double up = dot(a, harmonics_at({v.x + h * d.x, v.y + h * d.y, v.z + h * d.z}));
      const double down = dot(a, harmonics_at({v.x - h * d.x, v.y - h * d.y, v.z - h * d.z}));
      return (up - down) / (2 * h) / 4;
    };
    // Differences of second order: h^2 times third derivatives of a quartic of size 100 or so.
    CHECK(std::abs(slope({1, 0, 0}) - g.x) < 1e-6);
    CHECK(std::abs(slope({0, 1, 0}) - g.y) < 1e-6);
    CHECK(std::abs(slope({0, 0, 1}) - g.z) < 1e-6);
  }
}

TEST_CASE("Coefficients have length 1 and do not change with a rotation of the cube, but do with every other") {
  std::mt19937_64 random(3);
  for (int i = 0; i < 50; ++i) {
    const Quaternion q = test::random_rotation(random);
    const Harmonic h = harmonic_of(q);
    CHECK(std::abs(std::sqrt(dot(h, h)) - 1) < 1e-14);
    for (const Quaternion& g : quaternion::cube_group.element)
      CHECK(distance(harmonic_of(multiply(q, g)), h) < 1e-14);
    const Quaternion p = test::random_rotation(random);
    // Chord and angle: |h(p) - h(q)|^2 is 20/3 of the squared angle where that is small.
    CHECK(distance(harmonic_of(p), h) > 0.5 * symmetric_distance(p, q));
    const double small = 1e-4;
    const Quaternion near = turned(q, quaternion::rotate(p, {1, 0, 0}), small);
    CHECK(distance(harmonic_of(near), h) == doctest::Approx(std::sqrt(20.0 / 3) * small).epsilon(1e-5));
  }
}

TEST_CASE("A frame's coefficients, at any length, lead back to the frame to rounding") {
  std::mt19937_64 random(4);
  for (int i = 0; i < 300; ++i) {
    const Quaternion q = test::random_rotation(random);
    Harmonic a = harmonic_of(q);
    for (double& x : a)
      x *= 1e-3 * (i + 1);
    CHECK(symmetric_distance(nearest_frame(a), q) < 1e-8);
  }
}

TEST_CASE("The nearest frame to any coefficients is found: no other climb ends higher") {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 300; ++i) {
    Harmonic a;
    for (double& x : a)
      x = normal(random);
    const double found = dot(a, harmonic_of(nearest_frame(a)));
    double highest = -HUGE_VAL;
    for (int climb = 0; climb < 60; ++climb) {
      const Quaternion q = climb_to_frame(a, test::random_rotation(random));
      highest = std::max(highest, dot(a, harmonic_of(q)));
    }
    CHECK(found >= highest - 1e-9);
  }
}

TEST_CASE("Climbing ends where the gradient vanishes, never below its start") {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    Harmonic a;
    for (double& x : a)
      x = normal(random);
    const Quaternion start = test::random_rotation(random), q = climb_to_frame(a, start);
    const double value = dot(a, harmonic_of(q));
    CHECK(value >= dot(a, harmonic_of(start)));
    for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}}) {
      for (const double angle : {-1e-3, 1e-3})
        CHECK(dot(a, harmonic_of(turned(q, axis, angle))) <= value + 1e-12);
    }
  }
}

TEST_CASE("Frames about a direction lie on their circle") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20; ++i) {
    const Quaternion q = test::random_rotation(random);
    const Vector n = quaternion::rotate(q, {0, 1, 0});
    const AxisCircle circle = axis_circle(q, n);
    CHECK(std::abs(dot(circle.first, circle.first) - circle_radius_square) < 1e-14);
    CHECK(std::abs(dot(circle.second, circle.second) - circle_radius_square) < 1e-14);
    CHECK(std::abs(dot(circle.first, circle.second)) < 1e-14);
    CHECK(std::abs(dot(circle.first, circle.centre)) < 1e-14);
    CHECK(std::abs(dot(circle.second, circle.centre)) < 1e-14);
    for (const double t : {0.1, 0.5, 1.3, 3.0}) {
      Harmonic point;
      for (std::size_t k = 0; k < 9; ++k)
        point[k] = circle.centre[k] + std::cos(4 * t) * circle.first[k] + std::sin(4 * t) * circle.second[k];
      CHECK(distance(point, harmonic_of(turned(q, n, t))) < 1e-14);
    }
  }
}
