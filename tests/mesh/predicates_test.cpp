// The predicates against rational arithmetic, on inputs that rounding alone would get wrong.
#include "mesh/search/predicates.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "base/error.h"

using namespace orbicube::mesh;
using Rational = boost::multiprecision::cpp_rational;

namespace {

int exact_sign(const Vector3& p, const Vector3& q, const Vector3& r) {
  const auto x = [](const Vector3& v, int i) { return Rational(v[i]); };
  const Rational determinant = x(p, 0) * (x(q, 1) * x(r, 2) - x(q, 2) * x(r, 1)) +
                               x(p, 1) * (x(q, 2) * x(r, 0) - x(q, 0) * x(r, 2)) +
                               x(p, 2) * (x(q, 0) * x(r, 1) - x(q, 1) * x(r, 0));
  return determinant.sign();
}

int exact_sign(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  Rational m[3][3];
  for (int k = 0; k < 3; ++k) {
    m[0][k] = Rational(b[k]) - Rational(a[k]);
    m[1][k] = Rational(c[k]) - Rational(a[k]);
    m[2][k] = Rational(d[k]) - Rational(a[k]);
  }
  const Rational determinant = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) +
                               m[0][1] * (m[1][2] * m[2][0] - m[1][0] * m[2][2]) +
                               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return determinant.sign();
}

struct RandomPoints {
  std::mt19937_64 engine{7};
  double number() { return std::uniform_real_distribution<double>(-1, 1)(engine); }
  Vector3 point() { return Vector3(number(), number(), number()); }
};

}  // namespace

TEST_CASE("Orientation from the origin is exact for triples that are nearly in one plane, at any scale") {
  RandomPoints random;
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3 p = random.point();
    const Vector3 q = random.point();
    // In the plane of p and q but for rounding, and sometimes exactly.
    Vector3 r = i % 4 == 0 ? Vector3(p + q) : Vector3(random.number() * p + random.number() * q);
    if (i % 4 == 0 && i % 8 != 0) r = 2 * p;
    const double scale = std::ldexp(1.0, (i % 7 - 3) * 150);
    const int expected = exact_sign(p, q, r);
    zeros += expected == 0;
    REQUIRE(orientation_from_origin(p, q, r) == expected);
    REQUIRE(orientation_from_origin(scale * p, scale * q, scale * r) == exact_sign(scale * p, scale * q, scale * r));
    REQUIRE(orientation_from_origin(q, r, p) == expected);
    REQUIRE(orientation_from_origin(q, p, r) == -expected);
  }
  CHECK(zeros > 1000);
}

TEST_CASE("Orientation of four points is exact for points that are nearly in one plane, far from the origin too") {
  RandomPoints random;
  for (int i = 0; i < 20000; ++i) {
    const Vector3 shift = std::ldexp(1.0, i % 40) * random.point();
    const Vector3 a = shift + random.point();
    const Vector3 b = shift + random.point();
    const Vector3 c = shift + random.point();
    const Vector3 d = a + random.number() * (b - a) + random.number() * (c - a);
    const int expected = exact_sign(a, b, c, d);
    REQUIRE(orientation_3d(a, b, c, d) == expected);
    REQUIRE(orientation_3d(b, a, c, d) == -expected);
    REQUIRE(orientation_3d(c, a, b, d) == expected);
  }
}

TEST_CASE("Orientation in the plane is exact for points that are nearly on one line") {
  RandomPoints random;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector2d a(random.number(), random.number());
    const Eigen::Vector2d b(random.number(), random.number());
    const Eigen::Vector2d c = a + 3 * random.number() * (b - a);
    const Rational determinant = (Rational(b.x()) - Rational(a.x())) * (Rational(c.y()) - Rational(a.y())) -
                                 (Rational(b.y()) - Rational(a.y())) * (Rational(c.x()) - Rational(a.x()));
    REQUIRE(orientation_2d(a, b, c) == determinant.sign());
  }
}

TEST_CASE("The largest and the smallest doubles neither overflow nor vanish") {
  const double huge = 1.7e308;
  const double least = 5e-324;
  for (const double s : {huge, 1.0, 1e-160, least}) {
    CHECK(orientation_from_origin(Vector3(s, 0, 0), Vector3(0, s, 0), Vector3(0, 0, s)) == 1);
    CHECK(orientation_from_origin(Vector3(s, 0, 0), Vector3(0, 0, s), Vector3(0, s, 0)) == -1);
    CHECK(orientation_from_origin(Vector3(s, 0, 0), Vector3(0, s, 0), Vector3(s, s, 0)) == 0);
    CHECK(orientation_3d(Vector3(0, 0, 0), Vector3(s, 0, 0), Vector3(0, s, 0), Vector3(0, 0, s)) == 1);
    CHECK(orientation_2d({-s, 0}, {s, 0}, {0, s}) == 1);
  }
  CHECK(orientation_from_origin(Vector3(huge, 0, 0), Vector3(0, least, 0), Vector3(0, 0, least)) == 1);
}

TEST_CASE("Every permutation of the points has the sign of its parity, for points on a coarse grid too") {
  std::mt19937_64 engine(17);
  const auto number = [&] { return static_cast<double>(engine() % 3) * 0.1; };
  const auto point = [&] { return Vector3(number(), number(), number()); };
  const auto parity = [](const auto& order) {
    int sign = 1;
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        sign = order[j] > order[i] ? -sign : sign;
    }
    return sign;
  };
  for (int trial = 0; trial < 500; ++trial) {
    const std::array<Vector3, 4> x = {point(), point(), point(), point()};
    const int of_four = exact_sign(x[0], x[1], x[2], x[3]);
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    do {
      REQUIRE(orientation_3d(x[order[0]], x[order[1]], x[order[2]], x[order[3]]) == parity(order) * of_four);
    } while (std::next_permutation(order.begin(), order.end()));
    const int of_three = exact_sign(x[0], x[1], x[2]);
    const auto flat = [&](std::size_t i) -> Eigen::Vector2d { return x[i].head<2>(); };
    const int in_plane = orientation_2d(flat(0), flat(1), flat(2));
    std::array<std::size_t, 3> three{0, 1, 2};
    do {
      REQUIRE(orientation_from_origin(x[three[0]], x[three[1]], x[three[2]]) == parity(three) * of_three);
      REQUIRE(orientation_2d(flat(three[0]), flat(three[1]), flat(three[2])) == parity(three) * in_plane);
    } while (std::next_permutation(three.begin(), three.end()));
  }
}

TEST_CASE("Points whose products underflow or whose coordinates differ by hundreds of decades are decided exactly") {
  std::mt19937_64 engine(23);
  const auto number = [&] {
    const double mantissa = std::uniform_real_distribution<double>(-1, 1)(engine);
    return std::ldexp(mantissa, static_cast<int>(engine() % 2000) - 1060);
  };
  const auto point = [&] { return Vector3(number(), number(), number()); };
  for (int trial = 0; trial < 2000; ++trial) {
    const Vector3 p = point(), q = point();
    const Vector3 r = trial % 2 == 0 ? Vector3(p * 0.5) : point();
    REQUIRE(orientation_from_origin(p, q, r) == exact_sign(p, q, r));
    const Vector3 s = trial % 4 == 0 ? Vector3(q * 0.25) : point();
    REQUIRE(orientation_3d(p, q, r, s) == exact_sign(p, q, r, s));
  }
}

TEST_CASE("Coordinates that are not finite are refused") {
  const Vector3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  for (const double odd : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(orientation_3d(a, b, c, Vector3(0, 0, odd)), orbicube::base::Error);
    CHECK_THROWS_AS(orientation_from_origin(b, c, Vector3(1, odd, 1)), orbicube::base::Error);
    CHECK_THROWS_AS(orientation_2d({0, 0}, {1, 0}, {odd, 1}), orbicube::base::Error);
  }
}
