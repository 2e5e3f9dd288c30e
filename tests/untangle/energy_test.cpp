// The foldover energy: values, gradient and the kept part of the Hessian against formulas written again and
// differences.
#include "untangle/tetrahedra/foldover_energy.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "tangled_cases.h"

using namespace orbicube;
using namespace orbicube::untangle;

namespace {

// Six of the cubes of a bar, every vertex pushed about; some coordinates tied, some fixed.
struct Sample : test::PushedBar {
  explicit Sample(double push) : PushedBar(push) {
    for (std::size_t v = 0; v < start.size(); ++v) {
      if (mesh.positions[v][2] == 0) ties[3 * v + 2] = 4;
      if (mesh.positions[v][0] == 0) fixed[3 * v] = 1;
    }
  }
};

double weight_sum(const Array<Element>& elements) {
  double sum = 0;
  for (const Element& element : elements)
    sum += element.weight;
  return sum;
}

}  // namespace

TEST_CASE("A rigid motion of the target shapes has the minimum energy, five times the weights") {
  Sample s(0);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1, Vector3(1, 2, 2) / 3).toRotationMatrix();
  for (Vector3& p : s.start)
    p = turn * p + Vector3(3, 4, 5);
  const auto elements = elements_of(s.mesh.tetrahedra, s.mesh.positions, 1, s.host);
  const Variables variables(s.start, {}, {}, s.host.memory);
  FoldoverEnergy energy(elements, variables, 1, s.host);
  const EnergyValue value = energy.value(variables.start(), 0);
  CHECK(value.energy == doctest::Approx(5 * weight_sum(elements)).epsilon(1e-12));
  CHECK(value.min_determinant == doctest::Approx(1).epsilon(1e-12));
  CHECK(value.inverted == 0);
  std::vector<double> gradient(variables.free());
  energy.linearise(variables.start(), 0, gradient);
  for (const double g : gradient)
    CHECK(std::abs(g) < 1e-11);
}

TEST_CASE("Regular tetrahedra of a scale have that edge length") {
  base::Host host;
  const std::vector<Vector3> positions = {{0, 0, 0}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};  // edges of sqrt(2)
  const std::vector<Tetrahedron> tetrahedra = {{0, 1, 2, 3}};
  const auto elements = elements_of(tetrahedra, {}, std::sqrt(2.0), host);
  const Eigen::Matrix3d j = elements[0].jacobian(positions);
  CHECK((j.transpose() * j - Eigen::Matrix3d::Identity()).norm() < 1e-14);
  CHECK(j.determinant() == doctest::Approx(1));
}

TEST_CASE("The gradient is the derivative, with inverted elements too") {
  Sample s(0.4);
  const auto elements = elements_of(s.mesh.tetrahedra, s.mesh.positions, 1.3, s.host);
  const Variables variables(s.start, s.fixed, s.ties, s.host.memory);
  FoldoverEnergy energy(elements, variables, 0.7, s.host);
  for (const double eps : {1.0, 0.3}) {
    CHECK(energy.value(variables.start(), eps).inverted > 5);
    std::vector<double> gradient(variables.free());
    energy.linearise(variables.start(), eps, gradient);
    for (std::size_t i = 0; i < variables.free(); ++i) {
      std::vector<double> x(variables.start().begin(), variables.start().end());
      // Differences of fourth order: an error of 1e-4 ^ 4 beside rounding of 1e-16 / 1e-4.
      const double h = 1e-4;
      double derivative = 0;
      for (const auto& [by, factor] : {std::pair{1, 8.0}, {-1, -8.0}, {2, -1.0}, {-2, 1.0}}) {
        x[i] = variables.start()[i] + by * h;
        derivative += factor * energy.value(x, eps).energy / (12 * h);
      }
      CHECK(gradient[i] == doctest::Approx(derivative).epsilon(1e-6));
    }
  }
}

TEST_CASE("The Hessian's part is that of determinants that change linearly, where chi has no bend") {
  Sample s(0.1);
  const auto elements = elements_of(s.mesh.tetrahedra, s.mesh.positions, 1, s.host);
  const Variables variables(s.start, s.fixed, s.ties, s.host.memory);
  const double lambda = 0.7;
  FoldoverEnergy energy(elements, variables, lambda, s.host);
  REQUIRE(energy.value(variables.start(), 0).inverted == 0);
  std::vector<double> gradient(variables.free()), direction(variables.size(), 0), product(variables.free());
  energy.linearise(variables.start(), 0, gradient);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (std::size_t i = 0; i < variables.free(); ++i)
    direction[i] = uniform(random);
  std::vector<Vector3> at(s.start.size()), along(s.start.size());
  variables.expand(variables.start(), at);
  variables.expand(direction, along);
  const auto model = [&](double step) {
    double sum = 0;
    for (const Element& element : elements) {
      const Eigen::Matrix3d j = element.jacobian(at), k = element.jacobian(along);
      const double d = j.determinant() * (1 + step * (j.inverse() * k).trace());
      sum += element.weight * ((j + step * k).squaredNorm() / std::pow(d, 2.0 / 3) + lambda * (1 + d * d) / d);
    }
    return sum;
  };
  const double h = 1e-3;
  const double second = (-model(2 * h) + 16 * model(h) - 30 * model(0) + 16 * model(-h) - model(-2 * h)) / (12 * h * h);
  energy.multiply(std::span(direction).first(variables.free()), product);
  double curvature = 0;
  for (std::size_t i = 0; i < variables.free(); ++i)
    curvature += direction[i] * product[i];
  CHECK(curvature == doctest::Approx(second).epsilon(1e-7));
}

TEST_CASE("Newton's direction is that of the Hessian's part, with a matrix and without, fixed coordinates at rest") {
  Sample s(0.15);
  const auto elements = elements_of(s.mesh.tetrahedra, s.mesh.positions, 1, s.host);
  for (const bool tied : {false, true}) {
    const Variables variables(s.start, s.fixed, tied ? std::span<const Index>(s.ties) : std::span<const Index>(),
                              s.host.memory);
    CHECK(variables.any_shared() == tied);
    FoldoverEnergy energy(elements, variables, 0.7, s.host);
    std::vector<Pull> pulls(s.start.size());
    for (std::size_t v = 0; v < pulls.size(); ++v) {
      pulls[v].at = s.start[v];
      pulls[v].to_plane(Vector3(0, 0.6, 0.8), s.start[v] + Vector3(0.1, 0, 0), 0.3);
    }
    energy.set_pulls(pulls);
    for (const double eps : {0.5, 0.1}) {
      std::vector<double> gradient(variables.free()), direction(variables.free()), product(variables.free());
      energy.linearise(variables.start(), eps, gradient);
      energy.solve(gradient, 1000, 1e-12, direction);
      energy.multiply(direction, product);
      double residual = 0, right = 0;
      for (std::size_t i = 0; i < gradient.size(); ++i) {
        residual += (product[i] + gradient[i]) * (product[i] + gradient[i]);
        right += gradient[i] * gradient[i];
      }
      // The steps end at 1e-12 of the preconditioned residual; conditions are some thousands.
      CHECK(residual < 1e-16 * right);
    }
  }
}
