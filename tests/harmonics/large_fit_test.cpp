// Fits of high degrees: the product on the grid, the block of conjugate gradients, and what they end in.
#include "harmonics/fitting/large_fit.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "harmonics/fitting/block_conjugate_gradients.h"
#include "harmonics/fitting/gauss_grid.h"
#include "harmonics/fitting/gram_operator.h"
#include "samples.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::harmonics;
using test::host;

namespace {

double norm(std::span<const double> values) {
  double square = 0;
  for (const double value : values)
    square += value * value;
  return std::sqrt(square);
}

// Samples that are denser on one side, some of them of little weight.
struct LargeProblem {
  std::vector<Vector3> directions;
  std::vector<double> weights, values;
  Coefficients exact;

  LargeProblem(std::uint32_t degree, std::size_t channels, std::size_t count, double noise, std::uint64_t seed) {
    Samples samples(seed);
    exact = samples.coefficients(degree, channels);
    directions = samples.directions(count);
    for (Vector3& d : directions) {
      d = (d + Vector3(0.2, 0, 0.1)).normalized();
      weights.push_back(0.1 + samples.uniform());
    }
    values.resize(count * channels);
    synthesise(exact, directions, values, host);
    for (double& value : values)
      value += noise * samples.normal();
  }
};

// Of the gradient at a fit, of that at zero.
double gradient_left(const LargeProblem& p, const Coefficients& found) {
  std::vector<double> fitted(p.values.size());
  synthesise(found, p.directions, fitted, host);
  for (std::size_t i = 0; i < fitted.size(); ++i)
    fitted[i] = p.values[i] - fitted[i];
  Coefficients gradient = found.copy(), first = found.copy();
  analyse(p.directions, p.weights, fitted, gradient, "test", host);
  analyse(p.directions, p.weights, p.values, first, "test", host);
  return norm(gradient.values) / norm(first.values);
}

}  // namespace

TEST_CASE("The product on the grid with Fourier transforms is that of the normal equations' matrix") {
  for (const std::uint32_t degree : {0U, 1U, 7U, 40U, 150U}) {
    const std::size_t channels = degree > 40 ? 2 : 4;
    Samples samples(31);
    const Coefficients c = samples.coefficients(degree, channels), moments = samples.coefficients(2 * degree, 1);
    std::vector<double> expected(c.values.size()), product(c.values.size());
    GramOperator(moments, host).multiply(c.values, channels, expected);
    GaussGrid grid(degree, host);
    GaussGrid::Values density = grid.values(moments);
    grid.weigh(density);
    grid.multiply(density, c.values, channels, product);
    for (std::size_t i = 0; i < product.size(); ++i)
      product[i] -= expected[i];
    CHECK(norm(product) < 1e-13 * norm(expected));
  }
}

TEST_CASE("Synthesis on the grid and analysis return every coefficient, to 1e-13 up to degree 1000") {
  for (const std::uint32_t degree : {100U, 400U, 1000U}) {
    const Coefficients c = Samples(33).coefficients(degree, 1);
    std::vector<double> product(c.values.size());
    GaussGrid grid(degree, host);
    Coefficients one(0, 1, host.memory);
    one.values[0] = std::sqrt(4 * std::acos(-1.0));
    GaussGrid::Values density = grid.values(one);
    grid.weigh(density);
    grid.multiply(density, c.values, 1, product);
    double error = 0, largest = 0;
    for (std::size_t i = 0; i < product.size(); ++i) {
      error = std::max(error, std::abs(product[i] - c.values[i]));
      largest = std::max(largest, std::abs(c.values[i]));
    }
    CHECK(error < 1e-13 * largest);
  }
}

TEST_CASE("A block of columns is solved, also where columns are equal or zero") {
  constexpr Eigen::Index size = 40;
  constexpr std::size_t channels = 4;
  Samples samples(32);
  Eigen::MatrixXd root(size, size);
  Eigen::Matrix<double, size, channels, Eigen::RowMajor> b, x;
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j)
      root(i, j) = samples.normal();
    b.row(i) << samples.normal(), samples.normal(), 0, 0;
  }
  b.col(3) = b.col(0);
  const Eigen::MatrixXd g = root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(size, size);
  using Columns = Eigen::Map<Eigen::Matrix<double, size, channels, Eigen::RowMajor>>;
  using ConstColumns = Eigen::Map<const Eigen::Matrix<double, size, channels, Eigen::RowMajor>>;
  const Multiply multiply = [&](std::span<const double> from, std::size_t, std::span<double> to) {
    Columns(to.data()) = g * ConstColumns(from.data());
  };
  const Multiply precondition = [&](std::span<const double> from, std::size_t, std::span<double> to) {
    Columns(to.data()) = g.diagonal().cwiseInverse().asDiagonal() * ConstColumns(from.data());
  };
  const std::vector<double> tolerances(channels, 1e-11);
  const BlockReport report = block_conjugate_gradients(multiply, precondition, {b.data(), size * channels}, channels,
                                                       tolerances, 200, {x.data(), size * channels}, host);
  CHECK(report.converged);
  CHECK(report.iterations < size);
  CHECK((g * x - b).norm() < 1e-10 * b.norm());
  CHECK(x.col(2).isZero(0));
}

TEST_CASE("Degree 90 is recovered from 30 thousand samples") {
  const LargeProblem p(90, 2, 30'000, 0, 33);
  FitReport report;
  const Coefficients found = fit(p.directions, p.weights, p.values, 2, {.degree = 90}, host, report);
  CHECK(report.method == FitMethod::iterative);
  CHECK(report.rank == report.unknowns);
  CHECK(report.condition < 50);
  CHECK(max_difference(found, p.exact) < 1e-9);
  CHECK(report.residual < 1e-10);
}

TEST_CASE("High degrees: the residual is orthogonal to the basis, in the same bits for any number of threads") {
  // Samples for which gaps between them matter.
  const LargeProblem p(80, 3, 18'000, 0.3, 34);
  FitReport report;
  base::Host one, three;
  one.thread_count = 1;
  three.thread_count = 3;
  const Coefficients found = fit(p.directions, p.weights, p.values, 3, {.degree = 80}, one, report);
  CHECK(report.rank == report.unknowns);
  CHECK(gradient_left(p, found) < 1e-11);
  CHECK(found.values == fit(p.directions, p.weights, p.values, 3, {.degree = 80}, three, report).values);
}

TEST_CASE("High degrees: regularization minimizes the sum with the squared Laplacian" * doctest::test_suite("long")) {
  const LargeProblem p(80, 1, 12'000, 0.3, 35);
  constexpr double regularization = 1e-5;
  FitReport report;
  const Coefficients found =
      fit(p.directions, p.weights, p.values, 1, {.degree = 80, .regularization = regularization}, host, report);
  CHECK(report.rank == report.unknowns);
  std::vector<double> rest(p.values.size());
  synthesise(found, p.directions, rest, host);
  double total = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    rest[i] = p.values[i] - rest[i];
    total += p.weights[i];
  }
  const FitSamples samples{p.directions, p.weights, p.values, 1, total};
  Coefficients gradient(80, 1, host.memory), first(80, 1, host.memory);
  analyse(p.directions, p.weights, rest, gradient, "test", host);
  analyse(p.directions, p.weights, p.values, first, "test", host);
  for (std::uint32_t l = 0; l <= 80; ++l) {
    for (std::size_t k = l * l; k < basis_size(l); ++k)
      gradient.values[k] -= regularization_penalty(samples, {.regularization = regularization}, l) * found.values[k];
  }
  CHECK(norm(gradient.values) < 1e-11 * norm(first.values));
}

TEST_CASE("High degrees: a hole in the samples is reported as rank-deficient" * doctest::test_suite("long")) {
  Samples samples(36);
  std::vector<Vector3> directions;
  std::vector<double> values;
  while (directions.size() < 10'000) {
    const Vector3 d = samples.direction();
    if (d.z() > 0.5) continue;
    directions.push_back(d);
    values.push_back(d.x());
  }
  FitReport report;
  const Coefficients found =
      fit(directions, {}, values, 1, {.degree = 80, .method = FitMethod::iterative}, host, report);
  CHECK(report.rank < report.unknowns);
  CHECK(report.residual < 1e-3);
  CHECK(norm(found.values) < 10);
}
