// The transform of scattered points against the sums themselves.
#include "harmonics/scattered/scattered_transform.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "harmonics/rotations/rotation.h"
#include "samples.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::harmonics;
using test::host;

namespace {

std::vector<double> random_numbers(std::size_t count, unsigned seed) {
  Samples samples(seed);
  std::vector<double> numbers(count);
  for (double& number : numbers)
    number = samples.normal();
  return numbers;
}

// Random directions, the six axes, and points beside the poles and the meridian where phi starts.
std::vector<Vector3> scattered_directions(std::size_t count, unsigned seed) {
  std::vector<Vector3> directions;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    directions.push_back(Vector3::Unit(static_cast<Eigen::Index>(axis)));
    directions.push_back(-directions.back());
  }
  for (const double small : {1e-3, 1e-9, 1e-15, 1e-200}) {
    for (const double sign : {1.0, -1.0}) {
      directions.push_back(Vector3(sign * small, small, -sign).normalized());
      directions.push_back(Vector3(1, sign * small, small).normalized());
    }
  }
  Samples samples(seed);
  while (directions.size() < count)
    directions.push_back(samples.direction());
  return directions;
}

// The sum of a function's basis functions at a direction in long double, whose length is made 1 in it.
long double exact_sum(const Coefficients& c, const Vector3& direction) {
  const long double length =
      std::hypot(static_cast<long double>(direction.x()), static_cast<long double>(direction.y()),
                 static_cast<long double>(direction.z()));
  const std::complex<long double> turn(direction.x() / length, direction.y() / length);
  const long double z = direction.z() / length;
  long double sum = 0, product = 1;
  std::complex<long double> power = 1;
  for (std::uint32_t m = 0; m <= c.degree; ++m) {
    if (m > 0) product *= (2.0L * m - 1) / (2.0L * m);
    long double value = std::sqrt((m > 0 ? 2 : 1) * (2.0L * m + 1) / (4 * std::numbers::pi_v<long double>)*product);
    long double before = 0, last_factor = 1, cosine = 0, sine = 0;
    for (std::uint32_t l = m; l <= c.degree; ++l) {
      if (l > m) {
        const long double factor = std::sqrt((4.0L * l * l - 1) / (static_cast<long double>(l - m) * (l + m)));
        const long double next = factor * (z * value - before / last_factor);
        before = value;
        value = next;
        last_factor = factor;
      }
      const auto order = static_cast<std::int32_t>(m);
      cosine += c.at(l, order, 0) * value;
      if (m > 0) sine += c.at(l, -order, 0) * value;
    }
    sum += cosine * power.real() + sine * power.imag();
    power *= turn;
  }
  return sum;
}

double largest(std::span<const double> values) {
  double result = 0;
  for (const double value : values)
    result = std::max(result, std::abs(value));
  return result;
}

double largest_difference(std::span<const double> a, std::span<const double> b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    result = std::max(result, std::abs(a[i] - b[i]));
  return result;
}

}  // namespace

TEST_CASE("Fourier transforms of all radices are sums of waves") {
  for (const std::size_t length : std::vector<std::size_t>{2, 6, 16, 20, 30, 64, 90, 200, 450}) {
    REQUIRE(FourierTransform::fitting_length(length) == length);
    const FourierTransform transform(length, host.memory);
    const std::vector<double> numbers = random_numbers(2 * length * fourier_lanes, 3);
    for (const int sign : {-1, 1}) {
      std::vector<ComplexLanes> data(length), scratch(length);
      for (std::size_t k = 0; k < length * fourier_lanes; ++k) {
        data[k / fourier_lanes].real[k % fourier_lanes] = numbers[2 * k];
        data[k / fourier_lanes].imaginary[k % fourier_lanes] = numbers[2 * k + 1];
      }
      const std::vector<ComplexLanes> before = data;
      data = transform.transform(sign, data.data(), scratch.data()) == data.data() ? data : scratch;
      double error = 0;
      for (std::size_t j = 0; j < length; ++j) {
        for (std::size_t i = 0; i < fourier_lanes; ++i) {
          std::complex<double> sum = 0;
          for (std::size_t k = 0; k < length; ++k) {
            const double angle =
                sign * 2 * std::numbers::pi * static_cast<double>(j * k % length) / static_cast<double>(length);
            sum += std::complex(before[k].real[i], before[k].imaginary[i]) * std::polar(1.0, angle);
          }
          error = std::max(error, std::abs(sum - std::complex(data[j].real[i], data[j].imaginary[i])));
        }
      }
      CHECK(error < 1e-13 * std::sqrt(static_cast<double>(length)));
    }
  }
  CHECK(FourierTransform::fitting_length(7) == 8);
  CHECK(FourierTransform::fitting_length(1001) == 1024);
}

TEST_CASE("a scattered transform returns the sums themselves") {
  for (const std::uint32_t degree : {0U, 1U, 2U, 17U, 100U, 200U}) {
    const std::vector<Vector3> directions = scattered_directions(700, degree);
    const Coefficients coefficients = Samples(degree + 1).coefficients(degree, 2);
    std::vector<double> sums(2 * directions.size()), values(sums.size());
    // Few enough at a time that they are summed.
    constexpr std::size_t few = 50;
    REQUIRE(!ScatteredTransform::pays(few, degree));
    for (std::size_t first = 0; first < directions.size(); first += few)
      synthesise(coefficients, std::span(directions).subspan(first, few), std::span(sums).subspan(2 * first, 2 * few),
                 host);
    ScatteredTransform transform(directions, degree, "test", host);
    transform.synthesise(coefficients, 0, values);
    transform.synthesise(coefficients, 1, values);
    INFO("degree " << degree);
    // Beside the poles the sums themselves lose digits, the more the higher the degree is.
    const double tolerance = degree < 100 ? 2e-14 : 2e-13;
    CHECK(largest_difference(values, sums) < tolerance * largest(sums));

    const std::vector<double> samples = random_numbers(sums.size(), degree + 2);
    std::vector<double> weights = random_numbers(directions.size(), degree + 3);
    for (const bool weighted : {false, true}) {
      const std::span<const double> factors = weighted ? std::span<const double>(weights) : std::span<const double>();
      Coefficients expected(degree, 2, host.memory), part(degree, 2, host.memory), found(degree, 2, host.memory);
      for (std::size_t first = 0; first < directions.size(); first += few) {
        analyse(std::span(directions).subspan(first, few), weighted ? factors.subspan(first, few) : factors,
                std::span(samples).subspan(2 * first, 2 * few), part, "test", host);
        for (std::size_t k = 0; k < part.values.size(); ++k)
          expected.values[k] += part.values[k];
      }
      transform.analyse(factors, samples, 0, found);
      transform.analyse(factors, samples, 1, found);
      // Of 700 random values, which cancel.
      CHECK(largest_difference(found.values, expected.values) < 2e-13 * largest(expected.values));
    }
  }
}

TEST_CASE("a scattered transform has errors of 1e-13 up to degree 1000, at the poles as elsewhere") {
  // The moments of a fit have twice the degree.
  for (const std::uint32_t degree : {150U, 500U, 1000U, 2000U}) {
    const bool is_high = degree == 2000;
    std::vector<Vector3> directions = Samples(degree).directions(is_high ? 2 : 6);
    for (const double angle : {1e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3, 0.5, 0.53, 1.0, 1.5}) {
      if (is_high && directions.size() > 4) break;
      directions.emplace_back(0.6 * std::sin(angle), 0.8 * std::sin(angle), std::cos(angle));
      directions.emplace_back(-0.8 * std::sin(angle), 0.6 * std::sin(angle), -std::cos(angle));
    }
    const Coefficients coefficients = Samples(degree + 1).coefficients(degree, 1);
    std::vector<double> values(directions.size()), exact(directions.size());
    const base::Array<Vector3> unit = unit_directions(directions, host);
    ScatteredTransform transform(unit, degree, "test", host);
    transform.synthesise(coefficients, 0, values);
    for (std::size_t i = 0; i < unit.size(); ++i)
      exact[i] = static_cast<double>(exact_sum(coefficients, unit[i]));
    INFO("degree " << degree);
    CHECK(largest_difference(values, exact) < (is_high ? 3e-13 : 1e-13) * largest(exact));
  }
}

TEST_CASE("a scattered transform of single functions finds every coefficient") {
  // The analysis of a direction is all functions there.
  for (const std::uint32_t degree : {3U, 90U}) {
    const std::vector<Vector3> directions = scattered_directions(20, 5);
    for (const std::size_t at : {std::size_t{0}, std::size_t{4}, std::size_t{9}, std::size_t{19}}) {
      std::vector<double> one(directions.size()), row(basis_size(degree));
      one[at] = 1;
      ScatteredTransform transform(directions, degree, "test", host);
      Coefficients found(degree, 1, host.memory);
      transform.analyse({}, one, 0, found);
      evaluate(std::span(directions).subspan(at, 1), degree, row, host);
      // Up to 91 functions of each order are as large as 3 there.
      CHECK(largest_difference(found.values, row) < 1e-13 * largest(row));
    }
  }
}

TEST_CASE("the analysis of a scattered transform is the transpose of its synthesis") {
  for (const std::uint32_t degree : {5U, 150U, 400U}) {
    std::vector<Vector3> directions = scattered_directions(2000, 7);
    // Points that no grid tells apart, and more of them than one task works on.
    if (degree == 5) directions.resize(70000, directions[100]);
    const Coefficients x = Samples(8).coefficients(degree, 1);
    const std::vector<double> y = random_numbers(directions.size(), 9);
    std::vector<double> ax(directions.size());
    Coefficients aty(degree, 1, host.memory);
    ScatteredTransform transform(directions, degree, "test", host);
    transform.synthesise(x, 0, ax);
    transform.analyse({}, y, 0, aty);
    double left = 0, right = 0, size = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      left += ax[i] * y[i];
      size += std::abs(ax[i] * y[i]);
    }
    for (std::size_t k = 0; k < x.values.size(); ++k)
      right += x.values[k] * aty.values[k];
    CHECK(std::abs(left - right) < 1e-14 * size);
  }
}

TEST_CASE("a scattered transform of rotated functions has their values at rotated directions") {
  constexpr std::uint32_t degree = 120;
  const std::vector<Vector3> directions = scattered_directions(500, 11);
  const Coefficients coefficients = Samples(12).coefficients(degree, 1);
  const Eigen::Matrix3d rotation =
      (Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()) * Eigen::AngleAxisd(2, Vector3::UnitY())).matrix();
  const Coefficients turned = rotate(coefficients, rotation, host);
  std::vector<Vector3> moved;
  for (const Vector3& d : directions)
    moved.push_back((rotation * d).normalized());
  std::vector<double> values(directions.size()), moved_values(directions.size());
  ScatteredTransform(directions, degree, "test", host).synthesise(coefficients, 0, values);
  ScatteredTransform(moved, degree, "test", host).synthesise(turned, 0, moved_values);
  // The rotated directions are rounded, and the rotation of the coefficients rounds in each of 120 degrees.
  CHECK(largest_difference(values, moved_values) < 5e-13 * largest(values));
}

TEST_CASE("directions of which parts are as small as numbers can be have values beside those of the poles") {
  constexpr double tiny = 5e-324;
  const std::vector<Vector3> directions = {Vector3::UnitZ(),  Vector3(tiny, tiny, 1),       Vector3(-tiny, 3 * tiny, 1),
                                           -Vector3::UnitZ(), Vector3(2 * tiny, -tiny, -1), Vector3(0, -tiny, -1),
                                           Vector3::UnitX(),  Vector3(1, -tiny, tiny),      Vector3(1, tiny, -tiny)};
  for (const std::uint32_t degree : {10U, 300U}) {
    const Coefficients coefficients = Samples(3).coefficients(degree, 1);
    std::vector<double> values(directions.size());
    ScatteredTransform(directions, degree, "test", host).synthesise(coefficients, 0, values);
    for (std::size_t i = 0; i < values.size(); ++i)
      CHECK(std::abs(values[i] - values[i / 3 * 3]) < 1e-13 * largest(values));
  }
}

TEST_CASE("sums of many points take the scattered transform and have the same bits for any number of threads") {
  constexpr std::uint32_t degree = 90;
  const std::vector<Vector3> directions = scattered_directions(30000, 4);
  REQUIRE(ScatteredTransform::pays(directions.size(), degree));
  const Coefficients coefficients = Samples(5).coefficients(degree, 1);
  const std::vector<double> samples = random_numbers(directions.size(), 6);
  std::vector<double> first(directions.size());
  Coefficients first_sums(degree, 1, host.memory);
  for (const unsigned threads : {1U, 2U, 5U}) {
    base::Host other;
    other.thread_count = threads;
    std::vector<double> values(directions.size());
    Coefficients sums(degree, 1, host.memory);
    synthesise(coefficients, directions, values, other);
    analyse(directions, {}, samples, sums, "test", other);
    if (threads == 1) {
      first = values;
      first_sums = sums.copy();
    }
    CHECK(values == first);
    CHECK(sums.values == first_sums.values);
  }
  // Few points take the sums themselves.
  std::vector<double> few(200);
  synthesise(coefficients, std::span(directions).first(few.size()), few, host);
  CHECK(largest_difference(few, std::span(first).first(few.size())) < 1e-12 * largest(few));
}
