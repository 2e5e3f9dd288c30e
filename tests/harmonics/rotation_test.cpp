// Rotations by coefficients, and the search for the best one.
#include "harmonics/rotations/rotation.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "harmonics/functions/basis.h"
#include "harmonics/functions/spectrum.h"
#include "harmonics/rotations/alignment.h"
#include "harmonics/rotations/correlation_search.h"
#include "harmonics/rotations/generators.h"
#include "samples.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::harmonics;
using test::host;

namespace {

Matrix3 random_rotation(Samples& samples) {
  return Eigen::Quaterniond(samples.normal(), samples.normal(), samples.normal(), samples.normal())
      .normalized()
      .toRotationMatrix();
}

Matrix3 about(const Vector3& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

double angle_between(const Matrix3& a, const Matrix3& b) {
  // Twice the sine of half the angle: exact for small ones.
  return (a - b).norm() / std::sqrt(2.0);
}

// Coefficients that fall with the degree as those of a surface do.
Coefficients smooth(Samples& samples, std::uint32_t degree, std::size_t channels) {
  Coefficients f = samples.coefficients(degree, channels);
  for (std::uint32_t l = 1; l <= degree; ++l) {
    for (std::size_t k = std::size_t{l} * l * channels; k < basis_size(l) * channels; ++k)
      f.values[k] /= double(l) * l;
  }
  return f;
}

}  // namespace

TEST_CASE("What the function has at v, the rotated one has at R v, up to degree 150") {
  Samples samples(61);
  for (const std::uint32_t degree : {1U, 2U, 9U, 150U}) {
    const Coefficients g = samples.coefficients(degree, 2);
    std::vector<Matrix3> rotations = {
        Matrix3::Identity(),           about(Vector3(0, 0, 1), 0.7),     about(Vector3(0, 1, 0), std::acos(-1.0)),
        about(Vector3(1, 0, 0), 1e-9), about(Vector3(1, 1, 0), 3.14159), random_rotation(samples)};
    for (const Matrix3& r : rotations) {
      const Coefficients turned = rotate(g, r, host);
      std::vector<Vector3> directions = samples.directions(20), images;
      for (const Vector3& v : directions)
        images.push_back(r * v);
      std::vector<double> before(40), after(40);
      synthesise(g, directions, before, host);
      synthesise(turned, images, after, host);
      double largest = 0, size = 0;
      for (std::size_t i = 0; i < 40; ++i) {
        largest = std::max(largest, std::abs(before[i] - after[i]));
        size = std::max(size, std::abs(before[i]));
      }
      CHECK(largest < 2e-13 * (degree + 1) * size);
    }
  }
}

TEST_CASE("Rotations compose, keep the norms of the degrees, and so D_n") {
  Samples samples(62);
  const Coefficients g = samples.coefficients(40, 3), f = samples.coefficients(40, 3);
  const Matrix3 a = random_rotation(samples), b = random_rotation(samples);
  CHECK(max_difference(rotate(rotate(g, a, host), b, host), rotate(g, b * a, host)) < 1e-12);
  Coefficients turned = rotate(g, a, host);
  rotate_values(turned, b);
  CHECK(shape_distance(g, turned, 0, 40) < 1e-24);
  CHECK(shape_distance(f, turned, 0, 40) == doctest::Approx(shape_distance(f, g, 0, 40)).epsilon(1e-12));
  std::vector<double> before(41), after(41);
  degree_norms(g, before);
  degree_norms(turned, after);
  for (std::size_t l = 0; l <= 40; ++l)
    CHECK(after[l] == doctest::Approx(before[l]).epsilon(1e-13));
}

TEST_CASE("What is no rotation is refused") {
  const Coefficients g = Samples(63).coefficients(2, 1);
  CHECK_THROWS_AS(rotate(g, Matrix3::Zero(), host), base::Error);
  CHECK_THROWS_AS(rotate(g, -Matrix3::Identity(), host), base::Error);
  CHECK_THROWS_AS(rotate(g, 1.001 * Matrix3::Identity(), host), base::Error);
  CHECK_THROWS_AS(rotate(g, std::nan("") * Matrix3::Identity(), host), base::Error);
}

TEST_CASE("The generators are the derivatives of rotations") {
  Samples samples(64);
  const Coefficients g = samples.coefficients(12, 2);
  const auto slopes = generators(g);
  constexpr double step = 1e-5;
  for (int axis = 0; axis < 3; ++axis) {
    const Coefficients ahead = rotate(g, about(Vector3::Unit(axis), step), host),
                       behind = rotate(g, about(Vector3::Unit(axis), -step), host);
    double largest = 0;
    for (std::size_t k = 0; k < g.values.size(); ++k)
      largest = std::max(largest, std::abs((ahead.values[k] - behind.values[k]) / (2 * step) -
                                           slopes[static_cast<std::size_t>(axis)].values[k]));
    CHECK(largest < 1e-6);  // third derivatives of some 12^3, times step^2 / 6
  }
}

TEST_CASE("The grid holds the correlations that rotated coefficients have") {
  Samples samples(65);
  const Coefficients f = samples.coefficients(5, 3), g = samples.coefficients(5, 3);
  for (const bool turn_values : {false, true}) {
    const auto peaks = correlation_peaks(f, g, 5, turn_values, 5, host);
    REQUIRE(peaks.size() == 5);
    for (const CorrelationPeak& peak : peaks) {
      const Coefficients turned = rotate(g, peak.rotation, host);
      Matrix3 products = Matrix3::Zero();
      for (std::size_t k = 3; k < f.values.size(); k += 3) {
        products += Eigen::Map<const Vector3>(f.values.data() + k) *
                    Eigen::Map<const Vector3>(turned.values.data() + k).transpose();
      }
      double sum = products.trace();
      if (turn_values) best_rotation(products, sum);
      CHECK(std::abs(sum - peak.value) < 1e-11);
    }
    for (std::size_t k = 1; k < peaks.size(); ++k)
      CHECK(peaks[k].value <= peaks[k - 1].value);
  }
}

TEST_CASE("The best turn of values is at least as good as any other") {
  Samples samples(66);
  for (int k = 0; k < 20; ++k) {
    Matrix3 m;
    for (int i = 0; i < 9; ++i)
      m(i / 3, i % 3) = samples.normal();
    double sum = 0;
    const Matrix3 q = best_rotation(m, sum);
    CHECK((q * q.transpose() - Matrix3::Identity()).norm() < 1e-13);
    CHECK(q.determinant() > 0);
    CHECK(sum == doctest::Approx((q.transpose() * m).trace()).epsilon(1e-12));
    for (int j = 0; j < 50; ++j)
      CHECK((random_rotation(samples).transpose() * m).trace() <= sum);
  }
}

TEST_CASE("Known rotations are found again to 1e-8, from rough and from smooth functions, with noise of nothing") {
  Samples samples(67);
  for (const std::uint32_t degree : {2U, 5U, 16U, 30U}) {
    for (const std::size_t channels : {1UL, 3UL}) {
      for (const bool rough : {false, true}) {
        const Coefficients g = rough ? samples.coefficients(degree, channels) : smooth(samples, degree, channels);
        const Matrix3 r = random_rotation(samples);
        const Coefficients f = rotate(g, r, host);
        const Alignment found = align(f, g, {}, host);
        CAPTURE(degree);
        CAPTURE(channels);
        CAPTURE(rough);
        CHECK(angle_between(found.rotation, r) < 1e-8);
        CHECK(found.correlation == doctest::Approx(1).epsilon(1e-12));
        CHECK(found.values == Matrix3::Identity());
      }
    }
  }
}

TEST_CASE("Shapes that lie differently in space are aligned in both") {
  Samples samples(68);
  for (const std::uint32_t degree : {4U, 20U}) {
    const Coefficients g = smooth(samples, degree, 3);
    const Matrix3 r = random_rotation(samples), q = random_rotation(samples);
    Coefficients f = rotate(g, r, host);
    rotate_values(f, q);
    // Where a shape lies does not count.
    f.values[0] += 10;
    f.values[2] -= 7;
    const Alignment found = align(f, g, {.turn_values = true}, host);
    CHECK(angle_between(found.rotation, r) < 1e-8);
    CHECK(angle_between(found.values, q) < 1e-8);
    CHECK(found.correlation == doctest::Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("Of poses that are about as good, the one that turns the values least is taken on request") {
  Samples samples(71);
  for (int round = 0; round < 4; ++round) {
    // An ellipsoid as its own parameters: degree 1 alone, so four poses agree wholly, half turns apart.
    Coefficients ellipsoid(1, 3, host.memory);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::array<double, 3> axes{1, 2, 3};
      const std::array<std::size_t, 3> order{3, 1, 2};  // x goes with m = 1, y with m = -1, z with m = 0
      ellipsoid.values[3 * order[k] + k] = axes[k];
    }
    const Matrix3 r = random_rotation(samples);
    const Coefficients turned = rotate(ellipsoid, r, host);
    const Alignment found = align(turned, ellipsoid, {.turn_values = true, .prefer_standing = true}, host);
    CHECK(found.correlation == doctest::Approx(1).epsilon(1e-9));
    CHECK(angle_between(found.values, Matrix3::Identity()) < 1e-6);
    CHECK(angle_between(found.rotation, r) < 1e-6);
    // What lies differently is found as without.
    const Coefficients g = smooth(samples, 12, 3);
    const Matrix3 q = random_rotation(samples);
    Coefficients f = rotate(g, r, host);
    rotate_values(f, q);
    const Alignment other = align(f, g, {.turn_values = true, .prefer_standing = true}, host);
    CHECK(angle_between(other.values, q) < 1e-8);
  }
}

TEST_CASE("With noise, no rotation nearby and none of many others is better") {
  Samples samples(69);
  const Coefficients g = smooth(samples, 12, 3);
  Coefficients f = rotate(g, random_rotation(samples), host);
  for (double& c : f.values)
    c += 0.05 * samples.normal();
  const Alignment found = align(f, g, {}, host);
  const auto correlation = [&](const Matrix3& r) {
    const Coefficients turned = rotate(g, r, host);
    double sum = 0, ff = 0, gg = 0;
    for (std::size_t k = 3; k < f.values.size(); ++k) {
      sum += f.values[k] * turned.values[k];
      ff += f.values[k] * f.values[k];
      gg += g.values[k] * g.values[k];
    }
    return sum / std::sqrt(ff * gg);
  };
  CHECK(correlation(found.rotation) == doctest::Approx(found.correlation).epsilon(1e-12));
  for (int k = 0; k < 60; ++k) {
    CHECK(correlation(random_rotation(samples)) <= found.correlation);
    CHECK(correlation(about(samples.direction(), 1e-3) * found.rotation) < found.correlation);
  }
}

TEST_CASE("Alignment is the same bits for any number of threads") {
  Samples samples(70);
  const Coefficients f = samples.coefficients(8, 3), g = samples.coefficients(8, 3);
  base::Host one, three;
  one.thread_count = 1;
  three.thread_count = 3;
  const Alignment a = align(f, g, {.turn_values = true}, one), b = align(f, g, {.turn_values = true}, three);
  CHECK(a.rotation == b.rotation);
  CHECK(a.values == b.values);
  CHECK(a.correlation == b.correlation);
}

TEST_CASE("What cannot be aligned is refused") {
  Samples samples(71);
  const Coefficients one = samples.coefficients(3, 1), three = samples.coefficients(3, 3);
  CHECK_THROWS_AS(align(one, three, {}, host), base::Error);
  CHECK_THROWS_AS(align(one, one, {.turn_values = true}, host), base::Error);
  Coefficients constant(3, 1, std::pmr::get_default_resource());
  constant.values[0] = 1;
  CHECK_THROWS_WITH_AS(align(one, constant, {}, host), doctest::Contains("constant"), base::Error);
  Coefficients bad = one;
  bad.values[5] = std::nan("");
  CHECK_THROWS_AS(align(bad, one, {}, host), base::Error);
}
