// Statistics of populations: modes of a known construction, T2 by its definition, and p-values on and off the null.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "correspondence/statistics/group_test.h"
#include "correspondence/statistics/outliers.h"
#include "correspondence/statistics/principal_modes.h"

using namespace orbicube;
using correspondence::Population;

namespace {

// Sums of 12 uniform numbers: nearly normal, variance 1.
Population noise(Eigen::Index subjects, Eigen::Index points, std::uint64_t seed) {
  base::Random random(seed);
  Population x(subjects, 3 * points);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    double sum = -6;
    for (int k = 0; k < 12; ++k)
      sum += random.unit();
    x.data()[i] = sum;
  }
  return x;
}

std::vector<std::uint8_t> halves(std::size_t n) {
  std::vector<std::uint8_t> group(n, 0);
  for (std::size_t i = n / 2; i < n; ++i)
    group[i] = 1;
  return group;
}

base::Host host_of(unsigned thread_count) {
  base::Host host;
  host.thread_count = thread_count;
  return host;
}

}  // namespace

TEST_CASE("principal modes are those that a population is made of") {
  const Eigen::VectorXd a = noise(1, 20, 1).row(0).transpose().normalized();
  Eigen::VectorXd b = noise(1, 20, 2).row(0).transpose();
  b = (b - a.dot(b) * a).normalized();
  const Eigen::Vector4d s(3, -3, 3, -3), t(1, 1, -1, -1);
  const Population x = s * a.transpose() + t * b.transpose();
  const correspondence::PrincipalModes modes = correspondence::principal_modes(x, host_of(1));
  REQUIRE(modes.variances.size() == 2);
  CHECK(modes.variances(0) == doctest::Approx(12));
  CHECK(modes.variances(1) == doctest::Approx(4.0 / 3));
  CHECK(std::abs(modes.modes.col(0).dot(a)) == doctest::Approx(1));
  CHECK(std::abs(modes.modes.col(1).dot(b)) == doctest::Approx(1));
  CHECK(((modes.scores * modes.modes.transpose()) - x).norm() < 1e-12);
}

TEST_CASE("T2 of one point is that of its definition") {
  const Population x = noise(11, 1, 3);
  const std::vector<std::uint8_t> group = halves(11);
  const Eigen::MatrixXd a = x.topRows(5), b = x.bottomRows(6);
  const Eigen::RowVector3d d = b.colwise().mean() - a.colwise().mean();
  const Eigen::MatrixXd ca = a.rowwise() - a.colwise().mean(), cb = b.rowwise() - b.colwise().mean();
  const Eigen::Matrix3d pooled = (ca.transpose() * ca + cb.transpose() * cb) / 9;
  const double expected = 30.0 / 11 * d * pooled.inverse() * d.transpose();
  const correspondence::GroupTest test = correspondence::compare_groups(x, group, {}, host_of(1));
  CHECK(test.t2[0] == doctest::Approx(expected).epsilon(1e-9));
  CHECK(test.p[0] == test.p_family_wise[0]);
}

TEST_CASE("p-values without a difference are uniform, and bits do not depend on threads") {
  const Population x = noise(20, 400, 4);
  const correspondence::GroupTest one = correspondence::compare_groups(x, halves(20), {200, 1}, host_of(1));
  const correspondence::GroupTest three = correspondence::compare_groups(x, halves(20), {200, 1}, host_of(3));
  CHECK(one.t2 == three.t2);
  CHECK(one.p == three.p);
  CHECK(one.p_family_wise == three.p_family_wise);
  CHECK(one.q == three.q);
  // Kolmogorov-Smirnov at 0.1 % for 400 values, and the step of 201 permutations.
  std::vector<double> p = one.p;
  std::ranges::sort(p);
  double distance = 0;
  for (std::size_t i = 0; i < p.size(); ++i)
    distance = std::max(distance, std::abs(p[i] - static_cast<double>(i + 1) / static_cast<double>(p.size())));
  CHECK(distance < 1.95 / 20 + 1.0 / 201);
}

TEST_CASE("a difference is found where it is") {
  Population x = noise(30, 100, 5);
  x.block(15, 0, 15, 30).array() += 3;  // the first ten points of the second group
  const correspondence::GroupTest test = correspondence::compare_groups(x, halves(30), {500, 1}, host_of(2));
  for (std::size_t v = 0; v < 10; ++v)
    CHECK(test.p_family_wise[v] < 0.01);
  for (std::size_t v = 0; v < 10; ++v)
    CHECK(test.q[v] < 0.05);
  for (std::size_t v = 10; v < 100; ++v)
    CHECK(test.p_family_wise[v] > 0.01);
}

TEST_CASE("false-discovery rates are those of Benjamini and Hochberg") {
  const std::vector<double> p = {0.04, 0.01, 0.03, 0.5};
  const std::vector<double> q = correspondence::false_discovery_rates(p);
  CHECK(q[1] == doctest::Approx(0.04));
  CHECK(q[2] == doctest::Approx(0.16 / 3));
  CHECK(q[0] == doctest::Approx(0.16 / 3));
  CHECK(q[3] == doctest::Approx(0.5));
}

TEST_CASE("a regression on groups is the test of the groups, and finds a slope that is there") {
  Population x = noise(12, 3, 11);
  const std::vector<std::uint8_t> group = halves(12);
  const std::vector<double> values(group.begin(), group.end());
  const correspondence::GroupTest by_group = correspondence::compare_groups(x, group, {.permutations = 50}, host_of(1));
  const correspondence::GroupTest by_value = correspondence::regress(x, values, {.permutations = 50}, host_of(2));
  CHECK(by_group.p == by_value.p);
  CHECK(by_group.difference == by_value.difference);
  std::vector<double> age(12);
  for (std::size_t i = 0; i < age.size(); ++i) {
    age[i] = 50 + 3 * static_cast<double>(i * i);
    x.row(static_cast<Eigen::Index>(i)) *= 1e-9;
    x(static_cast<Eigen::Index>(i), 4) += 0.25 * age[i];
  }
  const correspondence::GroupTest slope = correspondence::regress(x, age, {.permutations = 99}, host_of(2));
  CHECK(slope.difference[4] == doctest::Approx(0.25));
  CHECK(std::abs(slope.difference[3]) < 1e-9);
  CHECK(slope.p[1] == doctest::Approx(0.01));
  CHECK_THROWS_AS(correspondence::regress(x, std::vector<double>(12, 3.0), {}, host_of(1)), base::Error);
  age[2] = std::nan("");
  CHECK_THROWS_AS(correspondence::regress(x, age, {}, host_of(1)), base::Error);
}

TEST_CASE("outliers are far above the median, whatever their number below half") {
  const std::vector<double> distances = {1, 1.1, 0.9, 1.05, 9, 0.95, 1e300, 0.01};
  CHECK(correspondence::outliers(distances) == std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 1, 0});
  CHECK(correspondence::outliers(std::vector<double>{1, 1, 1, 9}) == std::vector<std::uint8_t>(4, 0));
  CHECK(correspondence::outliers(std::vector<double>(6, 2.0)) == std::vector<std::uint8_t>(6, 0));
  CHECK(correspondence::outliers({}).empty());
  // The mean square of the distances from the mean is the sum of all variances, of N - 1 subjects and by point.
  const Population x = noise(9, 7, 3);
  const correspondence::PrincipalModes modes = correspondence::principal_modes(x, host_of(1));
  double squares = 0;
  for (const double distance : correspondence::distances_from_mean(x, modes.mean))
    squares += distance * distance;
  CHECK(squares == doctest::Approx(8 * modes.variances.sum() / 7));
}
