// The basis functions against closed forms, identities and an independent implementation, and the sums of them.
#include "harmonics/functions/basis.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "harmonics/functions/gauss_legendre.h"
#include "samples.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::harmonics;
using std::numbers::pi;
using test::host;

namespace {

std::vector<double> rows_at(const std::vector<Vector3>& directions, std::uint32_t degree) {
  std::vector<double> rows(directions.size() * basis_size(degree));
  evaluate(directions, degree, rows, host);
  return rows;
}

// P_l(x) in long double by the recurrence of Bonnet.
long double legendre(std::uint32_t l, long double x) {
  long double value = 1, before = 0;
  for (std::uint32_t j = 1; j <= l; ++j) {
    const long double next = ((2.0L * j - 1) * x * value - (j - 1.0L) * before) / j;
    before = value;
    value = next;
  }
  return value;
}

struct Grid {
  std::vector<Vector3> directions;
  std::vector<double> weights;

  // Exact for functions of degree 2 * degree.
  explicit Grid(std::uint32_t degree) {
    std::vector<double> node(degree + 1), weight(degree + 1);
    gauss_legendre(node, weight);
    const std::size_t longitudes = 2 * std::size_t{degree} + 1;
    for (std::size_t t = 0; t < node.size(); ++t) {
      for (std::size_t j = 0; j < longitudes; ++j) {
        const double phi = 2 * pi * (static_cast<double>(j) + 0.3) / static_cast<double>(longitudes);
        const double s = std::sqrt((1 - node[t]) * (1 + node[t]));
        directions.emplace_back(s * std::cos(phi), s * std::sin(phi), node[t]);
        weights.push_back(weight[t] * 2 * pi / static_cast<double>(longitudes));
      }
    }
  }
};

}  // namespace

TEST_CASE("The lowest basis functions are those of the definition") {
  const Vector3 d = Vector3(0.3, -0.5, 0.7).normalized();
  const std::vector<double> y = rows_at({d}, 2);
  const double one = std::sqrt(3 / (4 * pi)), two = std::sqrt(15 / (4 * pi));
  const double expected[] = {1 / std::sqrt(4 * pi),
                             one * d.y(),
                             one * d.z(),
                             one * d.x(),
                             two * d.x() * d.y(),
                             two * d.y() * d.z(),
                             std::sqrt(5 / (16 * pi)) * (3 * d.z() * d.z() - 1),
                             two * d.x() * d.z(),
                             two / 2 * (d.x() * d.x() - d.y() * d.y())};
  for (std::size_t k = 0; k < 9; ++k)
    CHECK(y[k] == doctest::Approx(expected[k]).epsilon(1e-15));
}

TEST_CASE("Up to degree 220 they agree with the standard library's to 1e-12") {
  // In long double, and with the Condon-Shortley phase that its version has.
  constexpr std::uint32_t degree = 220;
  Samples samples(1);
  std::vector<Vector3> directions = samples.directions(6);
  // Not nearer to the poles: the standard library's starts from cos theta, which has lost the digits there.
  directions.push_back(Vector3(0.05, 0.02, 1).normalized());
  directions.push_back(Vector3(-0.05, 0.02, -1).normalized());
  const std::vector<double> rows = rows_at(directions, degree);
  double largest = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vector3& d = directions[i];
    const long double flat = std::hypot(static_cast<long double>(d.x()), static_cast<long double>(d.y()));
    const long double theta = std::atan2(flat, static_cast<long double>(d.z()));
    const long double phi = std::atan2(static_cast<long double>(d.y()), static_cast<long double>(d.x()));
    for (std::uint32_t l = 0; l <= degree; l += l < 20 ? 1 : 25) {
      for (std::uint32_t m = 0; m <= l; ++m) {
        const long double p = std::sph_legendre(l, m, theta) * (m % 2 == 0 ? 1 : -1) * (m > 0 ? std::sqrt(2.0L) : 1);
        const auto order = static_cast<std::int32_t>(m);
        const double* row = rows.data() + i * basis_size(degree);
        largest = std::max(largest, std::abs(row[basis_index(l, order)] - static_cast<double>(p * std::cos(m * phi))));
        if (m > 0)
          largest =
              std::max(largest, std::abs(row[basis_index(l, -order)] - static_cast<double>(p * std::sin(m * phi))));
      }
    }
  }
  CHECK(largest < 1e-12);
}

TEST_CASE("At the poles all but the zonal functions vanish, exactly") {
  constexpr std::uint32_t degree = 300;
  const std::vector<double> rows = rows_at({Vector3(0, 0, 1), Vector3(0, 0, -2)}, degree);
  for (std::size_t pole = 0; pole < 2; ++pole) {
    double zonal = 0, others = 0;
    for (std::uint32_t l = 0; l <= degree; ++l) {
      const double sign = pole == 1 && l % 2 == 1 ? -1 : 1, exact = sign * std::sqrt((2.0 * l + 1) / (4 * pi));
      for (std::int32_t m = -static_cast<std::int32_t>(l); m <= static_cast<std::int32_t>(l); ++m) {
        const double y = rows[pole * basis_size(degree) + basis_index(l, m)];
        (m == 0 ? zonal : others) = std::max(m == 0 ? zonal : others, std::abs(m == 0 ? y / exact - 1 : y));
      }
    }
    CHECK(zonal < 1e-12);
    CHECK(others == 0);
  }
}

TEST_CASE("The addition theorem holds to 1e-12 at degree 250") {
  constexpr std::uint32_t degree = 250;
  Samples samples(2);
  std::vector<Vector3> directions = samples.directions(4);
  directions.emplace_back(0, 0, 1);
  directions.push_back(Vector3(1e-4, 1e-5, -1).normalized());
  const std::vector<double> rows = rows_at(directions, degree);
  const std::size_t size = basis_size(degree);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t j = i; j < directions.size(); ++j) {
      // The angle from both, which is exact where they are the same or opposite.
      const long double cosine =
          i == j ? 1
                 : directions[i].cast<long double>().dot(directions[j].cast<long double>()) /
                       (directions[i].cast<long double>().norm() * directions[j].cast<long double>().norm());
      for (const std::uint32_t l : {1U, 17U, 100U, 201U, 250U}) {
        double sum = 0;
        for (std::size_t k = std::size_t{l} * l; k < basis_size(l); ++k)
          sum += rows[i * size + k] * rows[j * size + k];
        const double exact = static_cast<double>(legendre(l, cosine));
        // Relative to the sum for i = j; the angle between two directions in double is known to some 1e-16.
        CHECK(std::abs(sum * 4 * pi / (2.0 * l + 1) - exact) < 1e-12);
      }
    }
  }
}

TEST_CASE("Gauss-Legendre quadrature is exact to its degree") {
  for (const std::size_t n : {1UL, 2UL, 5UL, 64UL, 401UL}) {
    std::vector<double> node(n), weight(n);
    gauss_legendre(node, weight);
    for (std::uint32_t l = 0; l < 2 * n; l += l < 10 ? 1 : 37) {
      double sum = 0;
      for (std::size_t k = 0; k < n; ++k)
        sum += weight[k] * static_cast<double>(legendre(l, node[k]));
      CHECK(std::abs(sum - (l == 0 ? 2 : 0)) < 1e-13);
    }
  }
}

TEST_CASE("The functions are orthonormal: analysis on a quadrature grid undoes synthesis, at degree 220" *
          doctest::test_suite("long")) {
  constexpr std::uint32_t degree = 220;
  const Grid grid(degree);
  const Coefficients given = Samples(3).coefficients(degree, 1);
  std::vector<double> values(grid.directions.size());
  synthesise(given, grid.directions, values, host);
  Coefficients back(degree, 1, std::pmr::get_default_resource());
  analyse(grid.directions, grid.weights, values, back, "test", host);
  CHECK(max_difference(given, back) < 1e-12);
}

TEST_CASE("Synthesis and analysis are the sums over the rows of the basis, for any number of channels and points") {
  constexpr std::uint32_t degree = 9;
  Samples samples(4);
  for (const std::size_t channels : {1UL, 2UL, 3UL, 5UL}) {
    for (const std::size_t count : {1UL, 63UL, 64UL, 1000UL}) {
      const std::vector<Vector3> directions = samples.directions(count);
      const std::vector<double> rows = rows_at(directions, degree);
      const Coefficients given = samples.coefficients(degree, channels);
      std::vector<double> values(count * channels), weights(count);
      for (double& w : weights)
        w = samples.uniform();
      synthesise(given, directions, values, host);
      Coefficients sums(degree, channels, std::pmr::get_default_resource());
      analyse(directions, weights, values, sums, "test", host);
      double wrong_values = 0, wrong_sums = 0;
      const std::size_t size = basis_size(degree);
      for (std::size_t c = 0; c < channels; ++c) {
        for (std::size_t i = 0; i < count; ++i) {
          double sum = 0;
          for (std::size_t k = 0; k < size; ++k)
            sum += given.values[k * channels + c] * rows[i * size + k];
          wrong_values = std::max(wrong_values, std::abs(sum - values[i * channels + c]));
        }
        for (std::size_t k = 0; k < size; ++k) {
          double sum = 0;
          for (std::size_t i = 0; i < count; ++i)
            sum += weights[i] * values[i * channels + c] * rows[i * size + k];
          wrong_sums = std::max(wrong_sums, std::abs(sum - sums.values[k * channels + c]));
        }
      }
      CHECK(wrong_values < 1e-13);
      CHECK(wrong_sums < 1e-12 * static_cast<double>(count));
    }
  }
}

TEST_CASE("Gradients are tangent and agree with differences") {
  constexpr std::uint32_t degree = 20;
  constexpr std::size_t channels = 2;
  Samples samples(5);
  std::vector<Vector3> directions = samples.directions(40);
  directions.emplace_back(0, 0, 1);
  const Coefficients given = samples.coefficients(degree, channels);
  std::vector<double> values(directions.size() * channels), plain(values.size());
  std::vector<Vector3> gradients(values.size());
  synthesise_with_gradients(given, directions, values, gradients, host);
  synthesise(given, directions, plain, host);
  for (std::size_t i = 0; i < values.size(); ++i)
    CHECK(std::abs(values[i] - plain[i]) < 1e-12);
  constexpr double step = 1e-5;
  double largest = 0, along = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Vector3& p = directions[i];
    const Vector3 tangent = p.unitOrthogonal();
    for (const Vector3& t : {tangent, Vector3(p.cross(tangent))}) {
      std::vector<double> ahead(channels), behind(channels);
      synthesise(given, std::vector<Vector3>{std::cos(step) * p + std::sin(step) * t}, ahead, host);
      synthesise(given, std::vector<Vector3>{std::cos(step) * p - std::sin(step) * t}, behind, host);
      for (std::size_t c = 0; c < channels; ++c) {
        const double slope = (ahead[c] - behind[c]) / (2 * step);
        largest = std::max(largest, std::abs(slope - gradients[i * channels + c].dot(t)));
        along = std::max(along, std::abs(gradients[i * channels + c].dot(p)));
      }
    }
  }
  // The third derivative of functions of this degree is some 20^4; rounding adds 1e-14 / step.
  CHECK(largest < 1e-4);
  CHECK(along < 1e-11);
}

TEST_CASE("Results are the same bits for any number of threads") {
  constexpr std::uint32_t degree = 30;
  Samples samples(6);
  const std::vector<Vector3> directions = samples.directions(40'000);
  const Coefficients given = samples.coefficients(degree, 3);
  base::Host one, four;
  one.thread_count = 1;
  four.thread_count = 4;
  std::vector<double> a(directions.size() * 3), b(a.size());
  synthesise(given, directions, a, one);
  synthesise(given, directions, b, four);
  CHECK(a == b);
  Coefficients c(degree, 3, std::pmr::get_default_resource()), d(degree, 3, std::pmr::get_default_resource());
  analyse(directions, {}, a, c, "test", one);
  analyse(directions, {}, a, d, "test", four);
  CHECK(c.values == d.values);
}

TEST_CASE("Directions that are none are refused, with their number") {
  std::vector<double> rows(8);
  for (const Vector3& bad :
       {Vector3(0, 0, 0), Vector3(std::nan(""), 0, 1), Vector3(0, std::numeric_limits<double>::infinity(), 0)}) {
    CHECK_THROWS_WITH_AS(evaluate(std::vector<Vector3>{Vector3(0, 0, 1), bad}, 1, rows, host),
                         doctest::Contains("direction 1"), base::Error);
  }
  CHECK_THROWS_AS(evaluate(std::vector<Vector3>{Vector3(0, 0, 1)}, largest_degree + 1, rows, host), base::Error);
  // Neither huge nor tiny ones lose anything.
  evaluate(std::vector<Vector3>{Vector3(1e300, 0, 1e300), Vector3(1e-310, 0, 1e-310)}, 1, rows, host);
  for (std::size_t k = 0; k < 4; ++k)
    CHECK(rows[k] == doctest::Approx(rows[4 + k]).epsilon(1e-12));
}
