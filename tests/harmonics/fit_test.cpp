// Fits: exact where they can be, at the minimum where not, and honest about what the samples do not determine.
#include "harmonics/fitting/fit.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "harmonics/fitting/gram_operator.h"
#include "samples.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::harmonics;
using test::host;

namespace {

struct Problem {
  std::vector<Vector3> directions;
  std::vector<double> weights, values;
  Coefficients exact;
};

// Samples of random functions, with uneven directions and weights, and noise.
Problem problem(std::uint32_t degree, std::size_t channels, std::size_t count, double noise, std::uint64_t seed) {
  Samples samples(seed);
  Problem p;
  p.exact = samples.coefficients(degree, channels);
  p.directions = samples.directions(count);
  for (Vector3& d : p.directions)
    d = (d + Vector3(0.4, 0, 0.2)).normalized();
  for (std::size_t i = 0; i < count; ++i)
    p.weights.push_back(0.1 + samples.uniform());
  p.values.resize(count * channels);
  synthesise(p.exact, p.directions, p.values, host);
  for (double& v : p.values)
    v += noise * samples.normal();
  return p;
}

Coefficients fitted(const Problem& p, const FitOptions& options, FitReport& report, const base::Host& with = host) {
  return fit(p.directions, p.weights, p.values, p.exact.channels, options, with, report);
}

// Weighted normal equations of the basis, made entry by entry, as an independent judge.
Eigen::MatrixXd gram(const Problem& p, std::uint32_t degree, Eigen::MatrixXd& rows) {
  const auto size = static_cast<Eigen::Index>(basis_size(degree)), n = static_cast<Eigen::Index>(p.directions.size());
  std::vector<double> values(static_cast<std::size_t>(n * size));
  evaluate(p.directions, degree, values, host);
  rows = Eigen::Map<Eigen::MatrixXd>(values.data(), size, n).transpose();
  return rows.transpose() * Eigen::Map<const Eigen::VectorXd>(p.weights.data(), n).asDiagonal() * rows;
}

}  // namespace

TEST_CASE("The product with the normal equations' matrix is that of its entries") {
  constexpr std::uint32_t degree = 7;
  const Problem p = problem(degree, 4, 300, 0, 11);
  Eigen::MatrixXd rows;
  const Eigen::MatrixXd entries = gram(p, degree, rows);
  Coefficients moments(2 * degree, 1, host.memory);
  analyse(p.directions, {}, p.weights, moments, "test", host);
  GramOperator matrix(moments, host);
  std::vector<double> product(p.exact.values.size());
  matrix.multiply(p.exact.values, 4, product);
  double largest = 0;
  for (Eigen::Index c = 0; c < 4; ++c) {
    const Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<4>> x(p.exact.values.data() + c, entries.cols()),
        y(product.data() + c, entries.cols());
    largest = std::max(largest, (entries * x - y).cwiseAbs().maxCoeff());
  }
  CHECK(largest < 1e-12 * entries.norm());
}

TEST_CASE("Band-limited functions are recovered by both methods") {
  for (const FitMethod method : {FitMethod::dense, FitMethod::iterative}) {
    for (const std::uint32_t degree : {0U, 1U, 6U, 12U}) {
      const Problem p = problem(degree, 3, 4 * basis_size(degree) + 10, 0, 12);
      FitReport report;
      const Coefficients found = fitted(p, {.degree = degree, .method = method}, report);
      CHECK(max_difference(found, p.exact) < 1e-12);
      CHECK(report.method == method);
      CHECK(report.unknowns == basis_size(degree));
      CHECK(report.rank == report.unknowns);
      CHECK(report.residual < 1e-12);
    }
  }
}

TEST_CASE("Degree 60 is recovered from 20 thousand samples") {
  const Problem p = problem(60, 1, 20'000, 0, 13);
  FitReport report;
  const Coefficients found = fitted(p, {.degree = 60}, report);
  CHECK(report.method == FitMethod::iterative);
  CHECK(report.rank == report.unknowns);
  CHECK(max_difference(found, p.exact) < 1e-11);
}

TEST_CASE("With noise, both methods end in the minimum: the residual is orthogonal to the basis") {
  constexpr std::uint32_t degree = 8;
  const Problem p = problem(degree, 2, 500, 0.3, 14);
  Eigen::MatrixXd rows;
  gram(p, degree, rows);
  Coefficients answers[2];
  for (const FitMethod method : {FitMethod::dense, FitMethod::iterative}) {
    FitReport report;
    const Coefficients found = fitted(p, {.degree = degree, .method = method}, report);
    double square = 0, total = 0;
    for (Eigen::Index c = 0; c < 2; ++c) {
      const Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<2>> x(found.values.data() + c, rows.cols()),
          f(p.values.data() + c, rows.rows());
      const Eigen::VectorXd rest = f - rows * x;
      const Eigen::Map<const Eigen::VectorXd> w(p.weights.data(), rows.rows());
      const Eigen::VectorXd gradient = rows.transpose() * w.cwiseProduct(rest);
      CHECK(gradient.norm() < 1e-12 * (rows.transpose() * w.cwiseProduct(f)).norm());
      square += rest.cwiseProduct(w).dot(rest);
      total = w.sum();
    }
    CHECK(report.residual == doctest::Approx(std::sqrt(square / total)).epsilon(1e-12));
    answers[method == FitMethod::dense ? 0 : 1] = found;
  }
  CHECK(max_difference(answers[0], answers[1]) < 1e-12);
}

TEST_CASE("The condition that is reported is that of the weighted basis") {
  constexpr std::uint32_t degree = 9;
  const Problem p = problem(degree, 1, 700, 0.1, 15);
  Eigen::MatrixXd rows;
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(gram(p, degree, rows)).eigenvalues();
  const double exact = std::sqrt(values[values.size() - 1] / values[0]);
  FitReport report;
  fitted(p, {.degree = degree, .method = FitMethod::iterative}, report);
  CHECK(report.condition == doctest::Approx(exact).epsilon(0.05));
  fitted(p, {.degree = degree, .method = FitMethod::dense}, report);
  // The diagonal of R bounds it from below, and is seldom off by much.
  CHECK(report.condition <= exact * (1 + 1e-9));
  CHECK(report.condition > exact / 10);
}

TEST_CASE("Too few samples: the rank is their number, and the shortest of the exact fits is taken") {
  constexpr std::uint32_t degree = 5;
  const Problem p = problem(degree, 2, 20, 0, 16);
  FitReport report;
  const Coefficients found = fitted(p, {.degree = degree}, report);
  CHECK(report.method == FitMethod::dense);
  CHECK(report.rank == 20);
  CHECK(report.residual < 1e-11);
  Eigen::MatrixXd rows;
  gram(p, degree, rows);
  const Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> judge(rows);
  for (Eigen::Index c = 0; c < 2; ++c) {
    const Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<2>> x(found.values.data() + c, rows.cols()),
        f(p.values.data() + c, rows.rows());
    CHECK((judge.solve(f) - x).norm() < 1e-10);
  }
}

TEST_CASE("Samples on one circle determine what can be seen there and nothing else") {
  // On the equator functions with l + m odd vanish, and all others are waves of order at most L: rank 2 L + 1.
  constexpr std::uint32_t degree = 6;
  std::vector<Vector3> directions;
  std::vector<double> values;
  for (int k = 0; k < 400; ++k) {
    const double phi = 0.1 + 2 * std::numbers::pi * k / 400;
    directions.emplace_back(std::cos(phi), std::sin(phi), 0);
    values.push_back(1 + std::cos(3 * phi) - 2 * std::sin(5 * phi));
  }
  for (const FitMethod method : {FitMethod::dense, FitMethod::iterative}) {
    FitReport report;
    const Coefficients found = fit(directions, {}, values, 1, {.degree = degree, .method = method}, host, report);
    CHECK(report.rank == 2 * degree + 1);
    CHECK(report.residual < 1e-7);
    double unseen = 0;
    for (std::uint32_t l = 0; l <= degree; ++l) {
      for (std::int32_t m = -static_cast<std::int32_t>(l); m <= static_cast<std::int32_t>(l); ++m) {
        if ((static_cast<std::int32_t>(l) + m) % 2 != 0) unseen = std::max(unseen, std::abs(found.at(l, m, 0)));
      }
    }
    CHECK(unseen < 1e-12);
  }
}

TEST_CASE("A hole in the samples is reported by the condition, and as rank-deficient when it is beyond rounding" *
          doctest::test_suite("long")) {
  Samples samples(17);
  std::vector<Vector3> directions;
  std::vector<double> values;
  while (directions.size() < 4000) {
    const Vector3 d = samples.direction();
    if (d.z() > 0.5) continue;
    directions.push_back(d);
    values.push_back(d.x());
  }
  FitReport report;
  fit(directions, {}, values, 1, {.degree = 4, .method = FitMethod::iterative}, host, report);
  CHECK(report.rank == report.unknowns);
  fit(directions, {}, values, 1, {.degree = 30, .method = FitMethod::iterative}, host, report);
  CHECK(report.rank < report.unknowns);
  CHECK(report.rank > report.unknowns / 2);
  // Smoothing makes up for what is missing.
  fit(directions, {}, values, 1, {.degree = 30, .method = FitMethod::iterative, .regularization = 1e-6}, host, report);
  CHECK(report.rank == report.unknowns);
}

TEST_CASE("Smoothing minimizes the sum with the squared Laplacian, by both methods") {
  constexpr std::uint32_t degree = 6;
  constexpr double regularization = 2e-3;
  const Problem p = problem(degree, 1, 300, 0.2, 18);
  Eigen::MatrixXd rows;
  Eigen::MatrixXd matrix = gram(p, degree, rows);
  const Eigen::Map<const Eigen::VectorXd> w(p.weights.data(), rows.rows()), f(p.values.data(), rows.rows());
  for (std::uint32_t l = 0; l <= degree; ++l) {
    const double laplacian = l * (l + 1.0);
    for (auto k = static_cast<Eigen::Index>(l * l); k < static_cast<Eigen::Index>(basis_size(l)); ++k)
      matrix(k, k) += regularization * w.sum() / (4 * std::numbers::pi) * laplacian * laplacian;
  }
  const Eigen::VectorXd exact = matrix.ldlt().solve(rows.transpose() * w.cwiseProduct(f));
  for (const FitMethod method : {FitMethod::dense, FitMethod::iterative}) {
    FitReport report;
    const Coefficients found =
        fitted(p, {.degree = degree, .method = method, .regularization = regularization}, report);
    CHECK((Eigen::Map<const Eigen::VectorXd>(found.values.data(), exact.size()) - exact).norm() < 1e-11 * exact.norm());
  }
}

TEST_CASE("Weights: zero is as if a sample were not there, two as if it were there twice") {
  Problem p = problem(3, 1, 80, 0.5, 19);
  for (std::size_t i = 0; i < 80; ++i)
    p.weights[i] = static_cast<double>(i % 3);
  Problem q = p;
  q.directions.clear();
  q.values.clear();
  q.weights.clear();
  for (std::size_t i = 0; i < 80; ++i) {
    for (std::size_t times = 0; times < i % 3; ++times) {
      q.directions.push_back(p.directions[i]);
      q.values.push_back(p.values[i]);
    }
  }
  FitReport report;
  const Coefficients a = fitted(p, {.degree = 3}, report), b = fitted(q, {.degree = 3}, report);
  CHECK(max_difference(a, b) < 1e-13);
}

TEST_CASE("Fits are the same bits for any number of threads") {
  const Problem p = problem(26, 3, 9000, 0.1, 20);
  FitReport report;
  base::Host one, three;
  one.thread_count = 1;
  three.thread_count = 3;
  CHECK(fitted(p, {.degree = 26}, report, one).values == fitted(p, {.degree = 26}, report, three).values);
}

TEST_CASE("What cannot be fitted is refused") {
  const Problem good = problem(2, 1, 30, 0, 21);
  FitReport report;
  const auto refused = [&](auto change) {
    Problem p = good;
    FitOptions options{.degree = 2};
    change(p, options);
    CHECK_THROWS_AS(fitted(p, options, report), base::Error);
  };
  refused([](Problem& p, FitOptions&) { p.values[3] = std::nan(""); });
  refused([](Problem& p, FitOptions&) { p.weights[3] = -1; });
  refused([](Problem& p, FitOptions&) { p.weights[3] = std::numeric_limits<double>::infinity(); });
  refused([](Problem& p, FitOptions&) { std::fill(p.weights.begin(), p.weights.end(), 0.0); });
  refused([](Problem& p, FitOptions&) { p.weights.pop_back(); });
  refused([](Problem& p, FitOptions&) { p.values.pop_back(); });
  refused([](Problem& p, FitOptions&) { p.directions[0] = Vector3::Zero(); });
  refused([](Problem& p, FitOptions&) {
    p.directions.clear();
    p.values.clear();
    p.weights.clear();
  });
  refused([](Problem&, FitOptions& o) { o.degree = largest_degree + 1; });
  refused([](Problem&, FitOptions& o) { o.regularization = -1; });
  refused([](Problem&, FitOptions& o) { o.method = static_cast<FitMethod>(7); });
}
