// Arithmetic of quaternions and the ways of writing a rotation, against each other and against closed forms.
#include "quaternion/rotation.h"

#include "base/error.h"
#include "quaternion/average.h"
#include "samples.h"

using namespace orbicube;
using namespace orbicube::test;
using namespace orbicube::quaternion;

namespace {

double entry(const Matrix& a, const Matrix& b, std::size_t row, std::size_t column) {
  return a[3 * row] * b[column] + a[3 * row + 1] * b[3 + column] + a[3 * row + 2] * b[6 + column];
}

}  // namespace

TEST_CASE("The product is Hamilton's: i j = k, and it is associative with lengths that multiply") {
  const Quaternion i{0, 1, 0, 0}, j{0, 0, 1, 0}, k{0, 0, 0, 1};
  CHECK(apart(multiply(i, j), k) == 0);
  CHECK(multiply(i, j).z == 1);
  CHECK(multiply(j, i).z == -1);
  CHECK(multiply(i, i).w == -1);
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Quaternion p = random_rotation(random), q = random_rotation(random), r = random_rotation(random);
    CHECK(apart(multiply(multiply(p, q), r), multiply(p, multiply(q, r))) < 4 * ulp);
    CHECK(std::abs(length(multiply(p, q)) - 1) < 4 * ulp);
    CHECK(apart(relative(q, p), multiply(conjugate(q), p)) < 4 * ulp);
    const Quaternion same = relative(q, q);
    CHECK((same.x == 0 && same.y == 0 && same.z == 0));
  }
}

TEST_CASE("Inverse and normalization work for every length that a double has") {
  std::mt19937_64 random(2);
  for (const double size : {1e-320, 1e-300, 1e-160, 1e-3, 1.0, 1e100, 1e160, 1e300}) {
    const Quaternion u = random_rotation(random);
    const Quaternion q{size * u.w, size * u.x, size * u.y, size * u.z};
    // Numbers as small as 1e-320 have few digits themselves.
    const double tolerance = size < 1e-310 ? 1e-2 : 4 * ulp;
    CHECK(apart(normalized(q), u) < tolerance);
    CHECK(std::abs(length(normalized(q)) - 1) <= 2 * ulp);
    if (size < 1e-307 || size > 1e299) continue;  // the inverse itself has no double
    CHECK(apart(multiply(q, inverse(q)), {1, 0, 0, 0}) < 8 * ulp);
  }
}

TEST_CASE("A unit quaternion turns vectors actively, as its matrix does, and products turn one after the other") {
  const double root = std::sqrt(0.5);
  const Vector turned = rotate({root, 0, 0, root}, {1, 0, 0});  // a quarter about z takes x to y
  CHECK(std::abs(turned.x) <= ulp);
  CHECK(std::abs(turned.y - 1) < 2 * ulp);
  const Vector v{0.3, -0.7, 1.1};
  const std::vector<Quaternion> rotations = many_rotations();
  for (std::size_t n = 0; n + 1 < rotations.size(); ++n) {
    const Quaternion &p = rotations[n], &q = rotations[n + 1];
    const Vector a = rotate(multiply(p, q), v), b = rotate(p, rotate(q, v));
    CHECK(std::abs(a.x - b.x) + std::abs(a.y - b.y) + std::abs(a.z - b.z) < 20 * ulp);
    const Matrix m = to_matrix(p);
    const Vector c = rotate(p, v);
    CHECK(std::abs(m[0] * v.x + m[1] * v.y + m[2] * v.z - c.x) < 10 * ulp);
    CHECK(std::abs(m[3] * v.x + m[4] * v.y + m[5] * v.z - c.y) < 10 * ulp);
    CHECK(std::abs(m[6] * v.x + m[7] * v.y + m[8] * v.z - c.z) < 10 * ulp);
    const Matrix right = to_matrix(q), both = to_matrix(multiply(p, q));
    for (std::size_t k = 0; k < 9; ++k)
      CHECK(std::abs(entry(m, right, k / 3, k % 3) - both[k]) < 12 * ulp);
  }
}

TEST_CASE("Every rotation comes back from its matrix to rounding, also near half turns") {
  for (const Quaternion& q : many_rotations()) {
    const Quaternion back = from_matrix(to_matrix(q));
    CHECK(apart(back, q) < 4 * ulp);
    CHECK(back.w >= 0);
    // The eigenvector's components are accurate to rounding against the largest, which is all that the matrix tells.
    CHECK(apart(nearest_to_matrix(to_matrix(q)), q) < 8 * ulp);
  }
}

TEST_CASE(
    "A matrix that is no rotation is refused, and its nearest rotation is at a stationary point of the distance") {
  for (const Matrix& m : {Matrix{}, Matrix{1, 0, 0, 0, 1, 0, 0, 0, -1}, Matrix{1, 0.01, 0, 0, 1, 0, 0, 0, 1},
                          Matrix{1, 0, 0, 0, std::nan(""), 0, 0, 0, 1}}) {
    CHECK_THROWS_AS(from_matrix(m), base::Error);
  }
  CHECK_THROWS_AS(nearest_to_matrix(Matrix{}), base::Error);
  CHECK_THROWS_AS(nearest_to_matrix(Matrix{-1, 0, 0, 0, -1, 0, 0, 0, -1}), base::Error);
  CHECK_THROWS_AS(nearest_to_matrix(Matrix{1, 0, 0, 0, std::nan(""), 0, 0, 0, 1}), base::Error);
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (const double size : {1e-200, 1.0, 1e200}) {
    Matrix m = to_matrix(random_rotation(random));
    for (double& value : m)
      value = size * (value + 0.2 * normal(random));
    const Matrix r = to_matrix(nearest_to_matrix(m));
    Matrix transposed;
    for (std::size_t k = 0; k < 9; ++k)
      transposed[k] = r[3 * (k % 3) + k / 3];
    // R'M is symmetric with a positive trace: the polar decomposition.
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < row; ++column) {
        CHECK(std::abs(entry(transposed, m, row, column) - entry(transposed, m, column, row)) < 1e-14 * size);
      }
    }
    CHECK(entry(transposed, m, 0, 0) + entry(transposed, m, 1, 1) + entry(transposed, m, 2, 2) > size);
  }
}

TEST_CASE("Axis and angle, and rotation vectors, go there and back") {
  const double pi = std::acos(-1.0);
  for (const Quaternion& q : many_rotations()) {
    const AxisAngle turn = to_axis_angle(q);
    CHECK(turn.angle >= 0);
    CHECK(turn.angle <= pi);
    CHECK(std::abs(std::hypot(turn.axis.x, turn.axis.y, turn.axis.z) - 1) < 4 * ulp);
    CHECK(apart(from_axis_angle(turn.axis, turn.angle), q) < 4 * ulp);
    CHECK(apart(from_rotation_vector(to_rotation_vector(q)), q) < 4 * ulp);
  }
  // The least angles keep their digits.
  const Vector tiny = to_rotation_vector(from_rotation_vector({3e-200, 0, -4e-200}));
  CHECK(tiny.x == doctest::Approx(3e-200).epsilon(1e-15));
  CHECK(tiny.z == doctest::Approx(-4e-200).epsilon(1e-15));
  const Quaternion third = from_axis_angle({2, 2, 2}, 2 * pi / 3);
  CHECK(apart(third, {0.5, 0.5, 0.5, 0.5}) < 2 * ulp);
  CHECK_THROWS_AS(from_axis_angle({0, 0, 0}, 1), base::Error);
  CHECK_THROWS_AS(from_axis_angle({1, std::nan(""), 0}, 1), base::Error);
}

TEST_CASE("The exponential undoes the logarithm for any quaternion, and follows its power series") {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    const Quaternion q{normal(random), normal(random), normal(random), normal(random)};
    CHECK(apart(exponential(logarithm(q)), q) < 10 * ulp * length(q));
    Quaternion sum{1, 0, 0, 0}, term{1, 0, 0, 0};
    for (int n = 1; n < 60; ++n) {
      term = multiply(term, q);
      term = {term.w / n, term.x / n, term.y / n, term.z / n};
      sum = {sum.w + term.w, sum.x + term.x, sum.y + term.y, sum.z + term.z};
    }
    // The series of a number of this length cancels down from terms of size e^|q|.
    CHECK(apart(exponential(q), sum) < 40 * ulp * std::exp(length(q)));
  }
  const double pi = std::acos(-1.0);
  for (const Quaternion& q : many_rotations(0)) {
    for (const Quaternion& side : {q, -q})
      CHECK(apart(exponential(logarithm(side)), side) < 4 * ulp);
  }
  CHECK(logarithm({-2, 0, 0, 0}).x == pi);
  CHECK(logarithm({-2, 0, 0, 0}).w == std::log(2.0));
  CHECK(logarithm({0, 0, 0, 0}).w == -std::numeric_limits<double>::infinity());
}

TEST_CASE("Slerp turns at constant speed along the shorter arc, also for tiny and for half turns") {
  std::mt19937_64 random(5);
  for (const Quaternion& step : many_rotations(50)) {
    const Quaternion p = random_rotation(random);
    const Quaternion q = multiply(p, step);
    CHECK(apart(slerp(p, q, 0), p) < 2 * ulp);
    CHECK(apart(slerp(p, q, 1), q) < 4 * ulp);
    CHECK(apart(slerp(p, -q, 1), q) < 4 * ulp);
    if (to_axis_angle(step).angle > 3.14159265) continue;  // two arcs of the same length
    const Vector whole = to_rotation_vector(step);
    for (const double t : {0.25, 0.5, 0.9, 1.7, -0.4}) {
      const Quaternion expected = multiply(p, from_rotation_vector({t * whole.x, t * whole.y, t * whole.z}));
      // Rounding of p and q turns the arc by at most ulp / its length, seen at t times its length.
      CHECK(apart(slerp(p, q, t), expected) < 20 * ulp);
      CHECK(std::abs(length(slerp(p, q, t)) - 1) <= 2 * ulp);
    }
  }
}

TEST_CASE("The average is Markley's: the same for other signs, in between for two, and no smaller sum nearby") {
  std::mt19937_64 random(6);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 20; ++trial) {
    const Quaternion centre = random_rotation(random);
    std::vector<double> q, flipped, weight;
    for (int i = 0; i < 15; ++i) {
      const Quaternion near =
          multiply(centre, from_rotation_vector({0.5 * normal(random), 0.5 * normal(random), 0.5 * normal(random)}));
      const double sign = i > 0 && random() % 2 ? -1 : 1;
      for (const double component : {near.w, near.x, near.y, near.z}) {
        q.push_back(component);
        flipped.push_back(sign * component);
      }
      weight.push_back(std::abs(normal(random)));
    }
    const Average average = quaternion::average(q.data(), weight.data(), 15);
    CHECK(apart(quaternion::average(flipped.data(), weight.data(), 15).mean, average.mean) == 0);
    const auto agreement = [&](const Quaternion& mean) {
      double sum = 0, total = 0;
      for (std::size_t i = 0; i < 15; ++i) {
        const double along = dot(mean, {q[4 * i], q[4 * i + 1], q[4 * i + 2], q[4 * i + 3]});
        sum += weight[i] * along * along;
        total += weight[i];
      }
      return sum / total;
    };
    CHECK(average.agreement == doctest::Approx(agreement(average.mean)).epsilon(1e-14));
    for (int direction = 0; direction < 20; ++direction) {
      const Quaternion away = multiply(
          average.mean, from_rotation_vector({1e-3 * normal(random), 1e-3 * normal(random), 1e-3 * normal(random)}));
      CHECK(agreement(away) < average.agreement);
    }
  }
  const Quaternion p = random_rotation(random), q = multiply(p, from_rotation_vector({0.4, 1, -0.8}));
  const double both[] = {p.w, p.x, p.y, p.z, q.w, q.x, q.y, q.z};
  CHECK(apart(quaternion::average(both, nullptr, 2).mean, slerp(p, q, 0.5)) < 4 * ulp);
}

TEST_CASE("What has no mean is refused") {
  const double opposite[] = {1, 0, 0, 0, 0, 1, 0, 0};
  const auto kind = [](const double* q, const double* weights, std::size_t count) {
    try {
      quaternion::average(q, weights, count);
    } catch (const base::Error& error) {
      return std::string(error.kind());
    }
    return std::string();
  };
  CHECK(kind(opposite, nullptr, 2) == "no-valid-result");
  CHECK(kind(opposite, nullptr, 0) == "invalid-argument");
  const double negative[] = {1, -1}, none[] = {0, 0}, one[] = {0, 1e-300}, bad[] = {1, 0, 0, std::nan("")};
  CHECK(kind(opposite, negative, 2) == "invalid-argument");
  CHECK(kind(opposite, none, 2) == "invalid-argument");
  CHECK(kind(bad, nullptr, 1) == "invalid-argument");
  CHECK(quaternion::average(opposite, one, 2).mean.x == 1);
}
