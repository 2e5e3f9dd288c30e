// Projections against closed forms, against plain bisection and by their optimality conditions; certificates against
// their definition.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "base/error.h"
#include "projected_gradient/row_equation.h"
#include "rows.h"

using namespace orbicube;
using namespace orbicube::test;
using projected_gradient::Projected;

namespace {

// The largest |x - clip(y + A't)|: together with the rows' residual all that makes x the projection of y.
double optimality_error(const Constraints& constraints, const std::vector<double>& y, const Projection& projection) {
  const std::vector<double> pull = constraints.transposed_times(projection.multipliers);
  double worst = 0;
  for (std::size_t j = 0; j < y.size(); ++j) {
    const double wanted = std::clamp(y[j] + pull[j], constraints.lower[j], constraints.upper[j]);
    worst = std::max(worst, std::abs(projection.x[j] - wanted) / (1 + std::abs(y[j]) + std::abs(pull[j])));
  }
  return worst;
}

// One row by 200 halvings of the multiplier in extended precision.
std::vector<double> bisected(const Constraints& c, const std::vector<double>& y) {
  long double low = -1e12L, high = 1e12L;
  std::vector<double> row(c.size()), x(c.size());
  for (std::size_t k = 0; k < c.column.size(); ++k)
    row[c.column[k]] += c.value[k];
  for (int halving = 0; halving < 200; ++halving) {
    const long double t = (low + high) / 2;
    long double sum = -c.rhs[0];
    for (std::size_t j = 0; j < x.size(); ++j) {
      const long double moved = std::clamp<long double>(y[j] + t * row[j], c.lower[j], c.upper[j]);
      x[j] = static_cast<double>(moved);
      sum += row[j] * moved;
    }
    (sum < 0 ? low : high) = t;
  }
  return x;
}

// c'A x < c'b for every x within the bounds, with bounds all finite: computed afresh.
bool proves_infeasible(const Constraints& constraints, std::span<const double> certificate) {
  const std::vector<double> c(certificate.begin(), certificate.end());
  const std::vector<double> slope = constraints.transposed_times(c);
  long double largest = 0, wanted = 0;
  for (std::size_t j = 0; j < slope.size(); ++j) {
    const double bound = slope[j] > 0 ? constraints.upper[j] : constraints.lower[j];
    largest += static_cast<long double>(slope[j]) * bound;
  }
  for (std::size_t i = 0; i < c.size(); ++i)
    wanted += static_cast<long double>(c[i]) * constraints.rhs[i];
  return largest < wanted;
}

}  // namespace

TEST_CASE("A box clips to its bounds bit for bit") {
  Constraints c(5, -0.1, 0.3);
  c.lower[1] = -infinity;
  c.upper[2] = infinity;
  const std::vector<double> y = {-1, -1e300, 1e300, 0.1 + 0.2, 0.25};
  CHECK(project(c, y).x == std::vector<double>{-0.1, -1e300, 1e300, 0.3, 0.25});
}

TEST_CASE("The unit simplex has its known projections") {
  Constraints c(3, 0, infinity);
  c.add_row({{0, 1}, {1, 1}, {2, 1}}, 1);
  const auto near = [&](const std::vector<double>& y, const std::vector<double>& x) {
    const Projection p = project(c, y);
    REQUIRE(p.outcome == Projected::done);
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(p.x[j] == doctest::Approx(x[j]).epsilon(1e-15));
  };
  near({0.5, 0.5, 0.5}, {1. / 3, 1. / 3, 1. / 3});
  near({2, 0, 0}, {1, 0, 0});
  near({1, 0.8, 0}, {0.6, 0.4, 0});
  near({-5, -5, -5}, {1. / 3, 1. / 3, 1. / 3});
}

TEST_CASE("One row agrees with bisection on random sets") {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 300; ++trial) {
    const std::size_t n = 1 + random() % 30;
    Constraints c(n);
    std::vector<std::pair<std::uint32_t, double>> row;
    std::vector<double> y(n);
    double rhs = 0;
    for (std::size_t j = 0; j < n; ++j) {
      c.lower[j] = random() % 5 == 0 ? -infinity : normal(random);
      c.upper[j] = random() % 5 == 0 ? infinity : std::max(c.lower[j], normal(random));
      const double inside = std::clamp(normal(random), c.lower[j], c.upper[j]);
      const double a = random() % 7 == 0 ? 0.0 : normal(random);
      row.emplace_back(static_cast<std::uint32_t>(j), a);
      rhs += a * inside;
      y[j] = 10 * normal(random);
    }
    c.add_row(row, rhs);
    const Projection p = project(c, y);
    REQUIRE(p.outcome == Projected::done);
    CHECK(c.within_bounds(p.x));
    CHECK(c.residual(p.x) < 1e-14);
    const std::vector<double> expected = bisected(c, y);
    for (std::size_t j = 0; j < n; ++j)
      CHECK(std::abs(p.x[j] - expected[j]) < 1e-9);
  }
}

TEST_CASE("A million unknowns onto a box and one row take fewer than 20 passes") {
  constexpr std::size_t n = 1000000;
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  for (const std::string shape : {"plain", "signed", "wide", "heavy tails", "ties", "far"}) {
    CAPTURE(shape);
    Constraints c(n, 0, 1);
    std::vector<std::pair<std::uint32_t, double>> row;
    std::vector<double> y(n);
    double rhs = 0;
    for (std::size_t j = 0; j < n; ++j) {
      double a = 0.5 + uniform(random);
      y[j] = normal(random);
      if (shape == "signed") a = normal(random);
      if (shape == "wide") {
        a = std::pow(10.0, 8 * uniform(random) - 4);
        c.upper[j] = std::pow(10.0, 6 * uniform(random) - 3);
      }
      if (shape == "heavy tails") y[j] = std::tan(3.14159 * (uniform(random) - 0.5));
      if (shape == "ties") y[j] = static_cast<double>(random() % 3), a = 1;
      if (shape == "far") y[j] *= 1e6;
      row.emplace_back(static_cast<std::uint32_t>(j), a);
      rhs += a * c.upper[j] * uniform(random);
    }
    c.add_row(row, rhs);
    const Projection p = project(c, y);
    REQUIRE(p.outcome == Projected::done);
    CHECK(p.passes < 20);
    CHECK(c.residual(p.x) < 1e-12);
    CHECK(optimality_error(c, y, p) < 1e-12);
    CHECK(c.within_bounds(p.x));
    MESSAGE(shape << ": " << p.passes << " passes, residual " << c.residual(p.x));
  }
}

TEST_CASE("Many rows meet the optimality conditions of the projection") {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial) {
    CAPTURE(trial);
    const std::size_t n = 3 + random() % 60, m = 2 + random() % std::min<std::size_t>(n / 2 + 1, 20);
    Constraints c(n);
    std::vector<double> inside(n), y(n);
    for (std::size_t j = 0; j < n; ++j) {
      c.lower[j] = random() % 6 == 0 ? -infinity : -std::abs(normal(random));
      c.upper[j] = random() % 6 == 0 ? infinity : std::abs(normal(random));
      inside[j] = std::clamp(0.7 * normal(random), c.lower[j], c.upper[j]);
      y[j] = 5 * normal(random);
    }
    for (std::size_t i = 0; i < m; ++i) {
      std::vector<std::pair<std::uint32_t, double>> row;
      double rhs = 0;
      const double scale = std::pow(10.0, normal(random));
      for (std::size_t k = 0; k < 4; ++k) {
        const auto j = static_cast<std::uint32_t>(random() % n);
        const double a = scale * normal(random);
        row.emplace_back(j, a);  // columns may repeat within a row
        rhs += a * inside[j];
      }
      c.add_row(row, rhs);
      if (trial % 4 == 0 && i == 0) c.add_row(row, rhs);  // a redundant row
    }
    const Projection p = project(c, y);
    REQUIRE(p.outcome == Projected::done);
    CHECK(c.within_bounds(p.x));
    CHECK(c.residual(p.x) < 1e-13);
    CHECK(optimality_error(c, y, p) < 1e-10);
  }
}

TEST_CASE(
    "Transport polytopes, whose rows are redundant, are met from near and far, and projecting twice changes nothing") {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  for (const std::size_t side : {2U, 5U, 30U}) {
    Constraints c(side * side, 0, infinity);
    for (std::size_t i = 0; i < side; ++i) {
      std::vector<std::pair<std::uint32_t, double>> row, column;
      for (std::size_t k = 0; k < side; ++k) {
        row.emplace_back(static_cast<std::uint32_t>(i * side + k), 1);
        column.emplace_back(static_cast<std::uint32_t>(k * side + i), 1);
      }
      c.add_row(row, 1);
      c.add_row(column, 1);
    }
    for (const double distance : {1e-9, 1e-3, 1.0, 1e3, 1e6}) {
      CAPTURE(side);
      CAPTURE(distance);
      std::vector<double> y(side * side, 1.0 / static_cast<double>(side));
      for (double& value : y)
        value += distance * normal(random);
      const Projection once = project(c, y);
      REQUIRE(once.outcome == Projected::done);
      CHECK(c.within_bounds(once.x));
      CHECK(c.residual(once.x) < 1e-13);
      CHECK(optimality_error(c, y, once) < 1e-12);
      const Projection twice = project(c, once.x);
      REQUIRE(twice.outcome == Projected::done);
      for (std::size_t j = 0; j < y.size(); ++j)
        CHECK(std::abs(twice.x[j] - once.x[j]) < 1e-12);
    }
  }
}

TEST_CASE("A set of one point is found") {
  Constraints c(4, 0, 1);
  c.add_row({{0, 1}, {1, 1}, {2, 1}, {3, 1}}, 4);  // only at the upper bounds
  CHECK(project(c, {-3, 0.5, 7, 0}).x == std::vector<double>(4, 1.0));
  c.add_row({{0, 1}, {1, -1}}, 0);
  const Projection p = project(c, {-3, 0.5, 7, 0});
  REQUIRE(p.outcome == Projected::done);
  for (const double x : p.x)
    CHECK(x == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("Rows that no point within the bounds meets come with a certificate") {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  int found = 0;
  for (int trial = 0; trial < 100; ++trial) {
    CAPTURE(trial);
    const std::size_t n = 2 + random() % 12, m = 1 + random() % 4;
    Constraints c(n, -1, 1);
    for (std::size_t i = 0; i < m; ++i) {
      std::vector<std::pair<std::uint32_t, double>> row;
      for (std::size_t j = 0; j < n; ++j)
        row.emplace_back(static_cast<std::uint32_t>(j), normal(random));
      c.add_row(row, 2 * normal(random) * std::sqrt(static_cast<double>(n)));
    }
    std::vector<double> y(n, 0.3), x(n);
    const base::Host host;
    projected_gradient::FeasibleSet set(c.problem(), host.memory);
    const Projected outcome = set.project(y, x, 1, host);
    CHECK(outcome != Projected::failed);
    if (outcome == Projected::done) {
      CHECK(c.residual(x) < 1e-13);
    } else {
      ++found;
      CHECK(set.certificate_gap() > 0);
      CHECK(proves_infeasible(c, set.certificate()));
    }
  }
  CHECK(found > 20);
  CHECK(found < 80);
}

TEST_CASE("Contradicting rows over unbounded unknowns come with a certificate") {
  Constraints c(3);
  c.add_row({{0, 1}, {1, 2}, {2, 3}}, 1);
  c.add_row({{0, 2}, {1, 4}, {2, 6}}, 5);
  std::vector<double> x(3);
  const base::Host host;
  projected_gradient::FeasibleSet set(c.problem(), host.memory);
  REQUIRE(set.project(std::vector<double>{1, 2, 3}, x, 1, host) == Projected::infeasible);
  // c'A = 0 and c'b > 0.
  const auto certificate = set.certificate();
  CHECK(certificate[0] + 2 * certificate[1] == doctest::Approx(0).epsilon(1e-9));
  CHECK(certificate[0] + 5 * certificate[1] > 0.1 * std::abs(certificate[0]));
}

TEST_CASE("Small random sets, some with infinite bounds, are met or proved empty") {
  int met = 0, empty = 0;
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    const std::size_t n = 1 + random() % 10;
    Constraints c(n);
    std::vector<double> y(n), inside(n), x(n);
    for (std::size_t j = 0; j < n; ++j) {
      if (random() % 4 != 0) c.lower[j] = normal(random) - 1;
      if (random() % 4 != 0) c.upper[j] = std::max(c.lower[j], normal(random) + 1);
      inside[j] = std::clamp(normal(random), c.lower[j], c.upper[j]);
      y[j] = std::pow(10.0, static_cast<double>(seed % 7)) * normal(random);
    }
    const bool feasible = seed % 2 == 0;
    for (std::size_t i = 0, m = random() % 6; i < m; ++i) {
      std::vector<std::pair<std::uint32_t, double>> row;
      double rhs = feasible ? 0 : normal(random);
      for (std::size_t k = 0, entries = random() % 5; k < entries; ++k) {
        row.emplace_back(static_cast<std::uint32_t>(random() % n), normal(random));
        rhs += row.back().second * inside[row.back().first];
      }
      c.add_row(row, rhs);
    }
    const base::Host host;
    projected_gradient::FeasibleSet set(c.problem(), host.memory);
    const Projected outcome = set.project(y, x, 1, host);
    if (feasible) CHECK(outcome != Projected::infeasible);
    if (outcome == Projected::done) {
      ++met;
      CHECK(c.within_bounds(x));
      CHECK(c.residual(x) < 1e-10);
    } else if (outcome == Projected::infeasible) {
      ++empty;
      CHECK(set.certificate_gap() > 0);
    }
  }
  MESSAGE(met << " met, " << empty << " proved empty, of 500");
  // Where y lies a million times farther away than the set is large, rounding of y + A't may leave it undecided.
  CHECK(met + empty >= 497);
}

TEST_CASE("An empty row is redundant or infeasible, by its right-hand side") {
  Constraints c(2, 0, 1);
  c.add_row({}, 0);
  c.add_row({{0, 1}}, 0.5);
  CHECK(project(c, {0, 2}).x == std::vector<double>{0.5, 1});
  c.rhs[0] = 1;
  CHECK(project(c, {0, 2}).outcome == Projected::infeasible);
}

TEST_CASE("What is no problem is refused, saying where") {
  const base::Host host;
  const auto refuses = [&](const Constraints& c) {
    CHECK_THROWS_AS(projected_gradient::FeasibleSet(c.problem(), host.memory), base::Error);
  };
  Constraints crossed(2, 0, 1);
  crossed.lower[1] = 2;
  refuses(crossed);
  Constraints unordered(2, 0, 1);
  unordered.upper[0] = std::nan("");
  refuses(unordered);
  Constraints outside(2);
  outside.add_row({{2, 1}}, 0);
  refuses(outside);
  Constraints endless(2);
  endless.add_row({{0, infinity}}, 0);
  refuses(endless);
  Constraints backwards(2);
  backwards.add_row({{0, 1}}, 0);
  backwards.add_row({{0, 1}}, 0);
  backwards.row_start = {0, 3, 2};
  refuses(backwards);
}
