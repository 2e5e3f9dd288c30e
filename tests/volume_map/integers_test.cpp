// Transitions between charts, integer equations and rounding: what is exact is checked as such, optima by trying all.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <limits>
#include <random>

#include "untangle/tetrahedra/variables.h"
#include "volume_map/frames/integer_rounding.h"
#include "volume_map/frames/transitions.h"

using namespace orbicube;
using namespace orbicube::volume_map;

namespace {

Transition random_transition(std::mt19937_64& random) {
  std::uniform_int_distribution<int> rotation(0, 23), shift(-50, 50);
  Transition t;
  t.rotation = static_cast<std::uint8_t>(rotation(random));
  for (auto& s : t.shift)
    s = shift(random);
  return t;
}

// The least cost over all integers of a box that meet the bounds, infinite if none does.
double min_cost(const Eigen::MatrixXd& curvature, const Eigen::VectorXd& best, const IntegerForms& forms,
                std::span<const LowerBound> bounds, int reach) {
  const auto count = static_cast<std::size_t>(best.size());
  Eigen::VectorXd c(best.size());
  double least = std::numeric_limits<double>::infinity();
  const auto side = static_cast<std::size_t>(2 * reach + 1);
  std::size_t all = 1;
  for (std::size_t i = 0; i < count; ++i)
    all *= side;
  for (std::size_t number = 0; number < all; ++number) {
    std::size_t rest = number;
    for (Eigen::Index i = 0; i < c.size(); ++i, rest /= side)
      c[i] = std::round(best[i]) + static_cast<double>(rest % side) - reach;
    bool met = true;
    for (const LowerBound& bound : bounds) {
      double sum = 0;
      for (const IntegerTerm& term : forms.terms(bound.form))
        sum += term.factor * c[term.unknown];
      met = met && sum >= bound.least;
    }
    if (met) least = std::min(least, (c - best).dot(curvature * (c - best)));
  }
  return least;
}

}  // namespace

TEST_CASE("transitions form a group and act as one, exactly") {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<int> place(-1000, 1000);
  for (int trial = 0; trial < 2000; ++trial) {
    const Transition a = random_transition(random), b = random_transition(random), c = random_transition(random);
    const Vector3 x(place(random), place(random), place(random));
    CHECK((a * b)(x) == a(b(x)));
    CHECK((a * b) * c == a * (b * c));
    CHECK(a * inverse(a) == Transition());
    CHECK(inverse(a) * a == Transition());
    CHECK(a * Transition() == a);
    CHECK(a(x) - a(Vector3::Zero()) == a.turn(x));
  }
}

TEST_CASE("sums of forms are sums of their terms") {
  IntegerForms forms(std::pmr::get_default_resource());
  const Index x = forms.of_unknown(4), y = forms.of_unknown(2);
  const Index sum = forms.sum(x, 3, y, -2);
  REQUIRE(forms.terms(sum).size() == 2);
  CHECK(forms.terms(sum)[0] == IntegerTerm{2, -2});
  CHECK(forms.terms(sum)[1] == IntegerTerm{4, 3});
  CHECK(forms.is_zero(forms.sum(sum, 2, sum, -2)));
  CHECK(forms.terms(forms.sum(sum, 1, y, 2)).size() == 1);
  CHECK(forms.sum(sum, 1, 0, 5) == sum);
}

TEST_CASE("a lattice has all integer solutions of its equations and no others") {
  std::mt19937_64 random(5);
  std::uniform_int_distribution<int> factor(-3, 3);
  for (int trial = 0; trial < 50; ++trial) {
    constexpr Index unknowns = 5;
    std::vector<std::vector<IntegerTerm>> equations;
    SolutionLattice lattice(unknowns, std::pmr::get_default_resource());
    for (int e = 0; e < 2; ++e) {
      std::vector<IntegerTerm> equation;
      for (Index u = 0; u < unknowns; ++u) {
        const int f = factor(random);
        if (f != 0) equation.push_back({u, f});
      }
      equations.push_back(equation);
      lattice.require_zero(equation);
    }
    // The unknowns by the coefficients, as a matrix.
    const auto dimension = static_cast<Eigen::Index>(lattice.dimension());
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(unknowns, dimension);
    Array<IntegerTerm> terms;
    for (Index u = 0; u < unknowns; ++u) {
      const IntegerTerm term{u, 1};
      lattice.express({&term, 1}, terms);
      for (const IntegerTerm& t : terms)
        basis(u, t.unknown) = t.factor;
    }
    for (const auto& equation : equations) {
      lattice.express(equation, terms);
      CHECK(terms.empty());
    }
    // Every integer solution has integer coefficients.
    int found = 0;
    for (int number = 0; number < 3125; ++number) {
      Eigen::VectorXd z(unknowns);
      for (int i = 0, rest = number; i < static_cast<int>(unknowns); ++i, rest /= 5)
        z[i] = rest % 5 - 2;
      bool solves = true;
      for (const auto& equation : equations) {
        double sum = 0;
        for (const IntegerTerm& t : equation)
          sum += t.factor * z[t.unknown];
        solves = solves && sum == 0;
      }
      if (!solves) continue;
      ++found;
      const Eigen::VectorXd c = basis.colPivHouseholderQr().solve(z);
      CHECK((basis * c - z).norm() < 1e-9);
      for (const double x : c)
        CHECK(std::abs(x - std::round(x)) < 1e-9);
    }
    CHECK(found >= 1);
  }
}

TEST_CASE("rounding finds the known optimum, with bounds and without") {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 60; ++trial) {
    constexpr Eigen::Index count = 4;
    Eigen::MatrixXd root(count, count);
    Eigen::VectorXd best(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      best[i] = 1.5 * normal(random);
      for (Eigen::Index j = 0; j < count; ++j)
        root(i, j) = normal(random);
    }
    const Eigen::MatrixXd curvature = root.transpose() * root + 0.4 * Eigen::MatrixXd::Identity(count, count);
    IntegerForms forms(std::pmr::get_default_resource());
    std::vector<LowerBound> bounds;
    if (trial % 2 == 1) {
      for (Index i = 0; i + 1 < static_cast<Index>(count); ++i)
        bounds.push_back({forms.sum(forms.of_unknown(i + 1), 1, forms.of_unknown(i), -1), trial % 3});
    }
    const Rounding found = round_integers(curvature, best, forms, bounds, {}, base::Host());
    CHECK(found.violated == 0);
    CHECK(found.optimal);
    for (const double x : found.integers)
      CHECK(x == std::round(x));
    CHECK(found.cost == doctest::Approx((found.integers - best).dot(curvature * (found.integers - best))));
    const double known = min_cost(curvature, best, forms, bounds, 5);
    CHECK(found.cost <= known * (1 + 1e-9) + 1e-12);
  }
}

TEST_CASE("bounds that contradict each other are reported") {
  IntegerForms forms(std::pmr::get_default_resource());
  const Index difference = forms.sum(forms.of_unknown(0), 1, forms.of_unknown(1), -1);
  const std::vector<LowerBound> bounds = {{difference, 1}, {forms.sum(difference, -1, 0, 1), 1}};
  const Rounding found = round_integers(Eigen::MatrixXd::Identity(2, 2), Eigen::VectorXd::Zero(2), forms, bounds,
                                        {.max_nodes = 1000}, base::Host());
  CHECK(found.violated > 0);
  CHECK_FALSE(found.optimal);
}

TEST_CASE("rounding ends where numbers are not finite, or so large that a step of 1 is none") {
  IntegerForms forms(std::pmr::get_default_resource());
  const Index difference = forms.sum(forms.of_unknown(0), 1, forms.of_unknown(1), -1);
  const std::vector<LowerBound> bounds = {{difference, 1}, {forms.sum(difference, -1, 0, 1), 1}};
  for (const double far : {1e17, 1e300, std::nan(""), -std::numeric_limits<double>::infinity()}) {
    for (const double stiff : {1.0, 1e300, std::nan("")}) {
      const Rounding found = round_integers(stiff * Eigen::MatrixXd::Identity(2, 2), Eigen::Vector2d(-far, far), forms,
                                            bounds, {.max_nodes = 1000}, base::Host());
      CHECK(found.integers.size() == 2);
    }
  }
}

TEST_CASE("coordinates that are tied with signs and shifts: values, changes and forces agree") {
  using Affine = untangle::Variables::Affine;
  // Two vertices share unknowns 0 and 2, the latter flipped and shifted; unknown 1 is one vertex's own.
  const std::vector<Affine> coordinates = {{0, 1, 0}, {1, -1, 4}, {no_index, 0, 7}, {2, 1, 0}, {2, -1, 3}, {0, 1, -2}};
  const std::vector<double> start = {0.5, 0.25, 2};
  const untangle::Variables variables(coordinates, start, std::pmr::get_default_resource());
  CHECK(variables.free() == 3);
  CHECK(variables.any_shared());
  std::vector<Vector3> x(2);
  variables.expand(variables.start(), x);
  CHECK(x[0] == Vector3(0.5, 3.75, 7));
  CHECK(x[1] == Vector3(2, 1, -1.5));
  // The derivative of a sum of forces times places, against differences, which are exact here.
  const std::vector<Vector3> force = {{1, 2, 4}, {8, 16, 32}};
  std::vector<double> reduced(3);
  variables.reduce(force, reduced);
  for (std::size_t i = 0; i < 3; ++i) {
    std::vector<double> values(variables.start().begin(), variables.start().end());
    values[i] += 1;
    std::vector<Vector3> moved(2), change(2);
    variables.expand(values, moved);
    std::vector<double> unit(variables.size(), 0.0);
    unit[i] = 1;
    variables.expand_change(unit, change);
    double rise = 0;
    for (std::size_t v = 0; v < 2; ++v) {
      CHECK(moved[v] - x[v] == change[v]);
      rise += force[v].dot(change[v]);
    }
    CHECK(rise == reduced[i]);
  }
}
