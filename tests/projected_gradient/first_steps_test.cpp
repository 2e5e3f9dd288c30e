// The default on boxes: its first trial, its two models of the Hessian, and its evaluations beside L-BFGS-B's.
#include <doctest/doctest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "projected_gradient/dense_model.h"
#include "projected_gradient/limited_memory.h"
#include "runs.h"

using namespace orbicube;
using namespace orbicube::test;
using projected_gradient::DenseModel;
using projected_gradient::FeasibleSet;
using projected_gradient::HessianModel;
using projected_gradient::LimitedMemory;

namespace {

double colville(std::span<const double> x, std::span<double> g) {
  const double a = x[1] - x[0] * x[0], b = x[3] - x[2] * x[2];
  const double c = 1 - x[0], d = 1 - x[2], e = x[1] - 1, h = x[3] - 1;
  g[0] = -400 * a * x[0] - 2 * c;
  g[1] = 200 * a + 20.2 * e + 19.8 * h;
  g[2] = -360 * b * x[2] - 2 * d;
  g[3] = 180 * b + 20.2 * h + 19.8 * e;
  return 100 * a * a + c * c + 90 * b * b + d * d + 10.1 * (e * e + h * h) + 19.8 * e * h;
}

double hock_schittkowski_5(std::span<const double> x, std::span<double> g) {
  const double sum = x[0] + x[1], difference = x[0] - x[1];
  g[0] = std::cos(sum) + 2 * difference - 1.5;
  g[1] = std::cos(sum) - 2 * difference + 2.5;
  return std::sin(sum) + difference * difference - 1.5 * x[0] + 2.5 * x[1] + 1;
}

double hock_schittkowski_110(std::span<const double> x, std::span<double> g) {
  double f = 0, product = 1;
  for (const double v : x)
    product *= v;
  const double root = std::pow(product, 0.2);
  for (std::size_t j = 0; j < x.size(); ++j) {
    const double low = std::log(x[j] - 2), high = std::log(10 - x[j]);
    f += low * low + high * high;
    g[j] = 2 * low / (x[j] - 2) - 2 * high / (10 - x[j]) - 0.2 * root / x[j];
  }
  return f - root;
}

// CUTEst's CVXBQP1.
double box_quadratic(std::span<const double> x, std::span<double> g) {
  const std::size_t n = x.size();
  double f = 0;
  std::fill(g.begin(), g.end(), 0.0);
  for (std::size_t i = 1; i <= n; ++i) {
    const std::size_t j = (2 * i - 1) % n, k = (3 * i - 1) % n;
    const double weight = static_cast<double>(i), sum = x[i - 1] + x[j] + x[k];
    f += 0.5 * weight * sum * sum;
    for (const std::size_t term : {i - 1, j, k})
      g[term] += weight * sum;
  }
  return f;
}

Case chain(std::size_t n) {
  Case c{Constraints(n, -2, 0.8), std::vector<double>(n), rosenbrock};
  for (std::size_t i = 0; i < n; ++i)
    c.start[i] = i % 2 == 0 ? -1.2 : 0.8;
  return c;
}

// The second point at which f is requested, for a linear f with this gradient, from zero.
std::vector<double> first_trial(const Constraints& constraints, const std::vector<double>& slope) {
  const Case c{constraints, std::vector<double>(slope.size()), [&](std::span<const double> x, std::span<double> g) {
                 std::copy(slope.begin(), slope.end(), g.begin());
                 return std::inner_product(x.begin(), x.end(), slope.begin(), 0.0);
               }};
  Options options;
  options.max_evaluations = 2;
  return run(c, options).asked.at(1);
}

}  // namespace

TEST_CASE("In a bounded box the first trial is P(x - g), else it is at most a unit away, of a small gradient a unit") {
  const std::vector<double> corner = first_trial(Constraints(2, -100, 7), {-50, 20});
  CHECK(corner == std::vector<double>{7, -20});
  Constraints half(2, 0, infinity);
  half.lower[0] = -infinity;
  const std::vector<double> unit = first_trial(half, {30, -40});
  CHECK(unit[0] == doctest::Approx(-0.6).epsilon(1e-14));
  CHECK(unit[1] == doctest::Approx(0.8).epsilon(1e-14));
  const std::vector<double> small = first_trial(Constraints(2, -100, 100), {1e-9, -5e-8});
  CHECK(small[1] == doctest::Approx(1).epsilon(1e-14));
  CHECK(small[0] == doctest::Approx(-0.02).epsilon(1e-14));
}

TEST_CASE("In boxes the default takes no more evaluations than L-BFGS-B in the sum, and reaches the known minima") {
  // Until |P(x - g) - x|inf is 1e-6; the counts of SciPy 1.17 with 10 pairs, measured on the same functions.
  struct Row {
    Case problem;
    double minimum;  // NaN: not published
    double theirs;
  };
  Constraints lower_only(2);
  lower_only.lower[1] = -1.5;
  Constraints five(2);
  five.lower = {-1.5, -3};
  five.upper = {4, 3};
  const double unknown = std::nan("");
  const std::vector<Row> rows = {
      {{lower_only, {-2, 1}, rosenbrock}, 0, 48},
      {{five, {0, 0}, hock_schittkowski_5}, -1.9132229549810, 8},
      {{Constraints(4, -10, 10), {-3, -1, -3, -1}, colville}, 0, 33},
      {{Constraints(10, 2.001, 9.999), std::vector<double>(10, 9.0), hock_schittkowski_110}, -45.7784697, 7},
      {chain(20), unknown, 44},
      {{Constraints(1000, 0.1, 10), std::vector<double>(1000, 0.5), box_quadratic}, 0.045 * 1000 * 1001 / 2, 2},
      {chain(1000), unknown, 37},
  };
  double ours = 0, theirs = 0;
  for (const Row& row : rows) {
    CAPTURE(row.theirs);
    Options options;
    options.gradient_tolerance = 1e-6;
    const Run end = run(row.problem, options);
    REQUIRE(end.result.stop == Stop::converged);
    CHECK(stationarity(row.problem, end.x) <= 1.01e-6);
    if (!std::isnan(row.minimum)) CHECK(std::abs(end.result.value - row.minimum) <= 1e-7 * (1 + std::abs(row.minimum)));
    const auto count = static_cast<double>(end.result.evaluations);
    MESSAGE(count << " evaluations, L-BFGS-B " << row.theirs);
    CHECK(count <= 1.5 * row.theirs);
    ours += count;
    theirs += row.theirs;
  }
  CHECK(ours <= theirs);
}

TEST_CASE("The matrix of few unknowns is that of the compact form, also after pairs were dropped") {
  constexpr std::size_t n = 7, pairs = 4;
  const base::Host host;
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  DenseModel dense(n, pairs, host.memory);
  LimitedMemory compact(n, 0, pairs, host.memory);
  Constraints box(n, -1, 1);
  FeasibleSet set(box.problem(), host.memory);
  std::vector<double> s(n), y(n), v(n), x(n), first(n), second(n);
  for (int step = 0; step < 10; ++step) {
    for (std::size_t j = 0; j < n; ++j) {
      s[j] = normal(random);
      y[j] = (1 + static_cast<double>(j)) * s[j] + 0.1 * s[(j + 1) % n] + 0.1 * s[(j + n - 1) % n];
      v[j] = normal(random);
      x[j] = (static_cast<int>(j) + step) % 3 == 0 ? 1 : 0;
    }
    REQUIRE(dense.push(s, y, 3));
    REQUIRE(compact.push(s, y, 3));
    // Sums of n products of numbers near 10: rounding is far below.
    constexpr double rounding = 1e-11;
    for (HessianModel* model : {static_cast<HessianModel*>(&dense), static_cast<HessianModel*>(&compact)}) {
      REQUIRE(model->minimise(v, first, host));
      model->prepare();
      REQUIRE(!model->empty());
      model->multiply(first, second, host);
      for (std::size_t j = 0; j < n; ++j)
        CHECK(std::abs(second[j] + v[j]) < rounding);
    }
    dense.multiply(s, first, host);
    for (std::size_t j = 0; j < n; ++j)
      CHECK(std::abs(first[j] - y[j]) < rounding);
    dense.multiply(v, first, host);
    compact.multiply(v, second, host);
    for (std::size_t j = 0; j < n; ++j)
      CHECK(std::abs(first[j] - second[j]) < rounding);
    set.choose_face(x);
    REQUIRE(dense.enter_face(set, host));
    REQUIRE(compact.enter_face(set, host));
    dense.minimise_in_face(set, v, first, host);
    compact.minimise_in_face(set, v, second, host);
    for (std::size_t j = 0; j < n; ++j) {
      CHECK(std::abs(first[j] - second[j]) < rounding);
      if (x[j] == 1) CHECK(first[j] == 0);
    }
  }
}
