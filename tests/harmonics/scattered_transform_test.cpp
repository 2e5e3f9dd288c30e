// The transform of scattered points against the sums themselves.
#include "harmonics/scattered/scattered_transform.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "samples.h"

using namespace orbicube;
using namespace orbicube::harmonics;

namespace {

const base::Host host;

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
      transform.transform(sign, data.data(), scratch.data());
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
  for (const std::uint32_t degree : {0U, 1U, 2U, 17U, 100U, 200U, 333U}) {
    const std::vector<Vector3> directions = scattered_directions(700, degree);
    REQUIRE(!ScatteredTransform::pays(directions.size(), degree));
    const Coefficients coefficients = Samples(degree + 1).coefficients(degree, 2);
    std::vector<double> sums(2 * directions.size()), values(sums.size());
    synthesise(coefficients, directions, sums, host);
    ScatteredTransform transform(directions, degree, "test", host);
    transform.synthesise(coefficients, 0, values);
    transform.synthesise(coefficients, 1, values);
    INFO("degree " << degree);
    // Beside the poles the sums themselves lose digits, the more the higher the degree is.
    const double tolerance = degree <= 200 ? 1e-12 : 1e-11;
    CHECK(largest_difference(values, sums) < tolerance * largest(sums));

    const std::vector<double> samples = random_numbers(sums.size(), degree + 2);
    std::vector<double> weights = random_numbers(directions.size(), degree + 3);
    Coefficients expected(degree, 2, host.memory), found(degree, 2, host.memory);
    for (const bool weighted : {false, true}) {
      const std::span<const double> factors = weighted ? std::span<const double>(weights) : std::span<const double>();
      analyse(directions, factors, samples, expected, "test", host);
      transform.analyse(factors, samples, 0, found);
      transform.analyse(factors, samples, 1, found);
      CHECK(largest_difference(found.values, expected.values) < tolerance * largest(expected.values));
    }
  }
}

TEST_CASE("the analysis of a scattered transform is the transpose of its synthesis") {
  for (const std::uint32_t degree : {5U, 150U}) {
    const std::vector<Vector3> directions = scattered_directions(2000, 7);
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
