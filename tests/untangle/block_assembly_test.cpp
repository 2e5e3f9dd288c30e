// Matrices of blocks and their solvers against dense ones made of products with the Hessian.
#include "untangle/tetrahedra/block_assembly.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <random>
#include <vector>

#include "tangled_cases.h"
#include "untangle/tetrahedra/foldover_energy.h"

using namespace orbicube;
using namespace orbicube::untangle;

namespace {

// A bar pushed about, with planes, ties across axes and vertices, groups within one vertex, and fixed coordinates.
struct Problem : test::PushedBar {
  Array<Element> elements;
  std::mt19937_64 random{11};

  explicit Problem(bool tied) : PushedBar(0.3), elements(elements_of(mesh.tetrahedra, mesh.positions, 1, host)) {
    if (!tied) ties.clear();
    for (std::size_t v = 0; v < start.size(); ++v) {
      if (mesh.positions[v][0] == 0) fixed[3 * v] = fixed[3 * v + 2] = 1;
      if (!tied) continue;
      if (mesh.positions[v][2] == 0) ties[3 * v + 2] = 4;
      if (mesh.positions[v][0] == 2) ties[3 * v] = 7, ties[3 * v + 1] = 7;
      if (mesh.positions[v][1] == 1) ties[3 * v + 1] = static_cast<Index>(10 + v / 2);
      if (mesh.positions[v][2] == 0) fixed[3 * v + 2] = 0;
    }
  }
  Vector3 vector() {
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double x = uniform(random), y = uniform(random);
    return {x, y, uniform(random)};
  }
};

}  // namespace

TEST_CASE("The matrix of blocks is the Hessian's part, what is shared and what stays included") {
  for (const bool tied : {false, true}) {
    Problem p(tied);
    const Variables variables(p.start, p.fixed, p.ties, p.host.memory);
    CHECK(variables.any_shared() == tied);
    FoldoverEnergy energy(p.elements, variables, 0.7, p.host);
    const std::size_t n = variables.free(), m = energy.matrix().size();
    std::vector<double> gradient(n), direction(n, 0), product(n), entries(m), result(m);
    energy.linearise(variables.start(), 0.05, gradient);
    Eigen::MatrixXd wanted(n, n), found(n, n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto at = static_cast<Eigen::Index>(i);
      direction[i] = 1;
      energy.multiply(direction, product);
      wanted.col(at) = Eigen::Map<const Eigen::VectorXd>(product.data(), wanted.rows());
      energy.assembly().scatter(direction, entries);
      energy.matrix().multiply(entries, result, p.host);
      energy.assembly().gather(result, product);
      found.col(at) = Eigen::Map<const Eigen::VectorXd>(product.data(), found.rows());
      // Nothing comes to what is no unknown.
      std::vector<double> again(m);
      energy.assembly().scatter(product, again);
      CHECK(again == result);
      direction[i] = 0;
    }
    CHECK((wanted - wanted.transpose()).norm() < 1e-12 * wanted.norm());
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(wanted).eigenvalues();
    CHECK(values.minCoeff() > -1e-12 * values.maxCoeff());
    // Some billionths of each block are added to its diagonal.
    CHECK((wanted - found).norm() < 1e-7 * wanted.norm());
  }
}

TEST_CASE("Sweeps solve with the halves of the matrix, and conjugate gradients with the whole") {
  for (const bool tied : {false, true}) {
    Problem p(tied);
    const Variables variables(p.start, p.fixed, p.ties, p.host.memory);
    FoldoverEnergy energy(p.elements, variables, 1, p.host);
    std::vector<double> gradient(variables.free());
    energy.linearise(variables.start(), 0.3, gradient);
    BlockMatrix matrix = energy.matrix();
    linear::GaussSeidel<3> solver(p.host);
    solver.factor(matrix);
    const std::size_t m = matrix.size();
    std::vector<double> x(m), y(m);
    Eigen::MatrixXd dense(m, m);
    for (std::size_t i = 0; i < m; ++i) {
      x[i] = 1;
      matrix.multiply(x, y, p.host);
      dense.col(static_cast<Eigen::Index>(i)) = Eigen::Map<const Eigen::VectorXd>(y.data(), dense.rows());
      x[i] = 0;
    }
    // Lower by blocks: rows of a vertex belong together.
    Eigen::MatrixXd lower = dense;
    const auto block = [&](Eigen::Index i) {
      const auto rows = static_cast<Eigen::Index>(matrix.rows());
      return i < 3 * rows ? i / 3 : i - 2 * rows;
    };
    for (Eigen::Index i = 0; i < lower.rows(); ++i) {
      for (Eigen::Index j = 0; j < lower.cols(); ++j) {
        if (block(j) > block(i)) lower(i, j) = 0;
      }
    }
    std::vector<double> right(m);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (double& entry : right)
      entry = uniform(p.random);
    const Eigen::Map<const Eigen::VectorXd> b(right.data(), dense.rows());
    const Eigen::Map<const Eigen::VectorXd> found(x.data(), dense.rows());
    x = right;
    solver.forward(x);
    CHECK((lower * found - b).norm() < 1e-9 * b.norm());
    x = right;
    solver.backward(x);
    CHECK((lower.transpose() * found - b).norm() < 1e-9 * b.norm());
    const int steps = solver.solve(right, 1000, 1e-12, x);
    CHECK(steps > 5);
    CHECK(steps < 300);
    // The steps end at 1e-12 of the preconditioned residual; rows differ in size by a million.
    CHECK((dense * found - b).norm() < 1e-5 * b.norm());
    CHECK(solver.solve(right, 3, 1e-12, x) == 3);
  }
}

TEST_CASE("Multigrid solves the same systems, in steps that hardly grow with them") {
  for (const bool tied : {false, true}) {
    std::vector<int> steps;
    for (const int n : {6, 12}) {
      const auto c = test::polycube_start({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, n, 0.1, 0, 0);
      const base::Host host;
      const auto elements = elements_of(c.tetrahedra, c.rest, 1, host);
      std::vector<std::uint8_t> fixed = c.fixed;
      for (std::size_t i = 0; i < fixed.size() && !tied; ++i)
        fixed[i] = c.ties[i] != no_index;
      const Variables variables(c.start, fixed, tied ? std::span<const Index>(c.ties) : std::span<const Index>(),
                                host.memory);
      FoldoverEnergy energy(elements, variables, 1, host);
      std::vector<double> gradient(variables.free());
      energy.linearise(variables.start(), 0.5, gradient);
      BlockMatrix matrix = energy.matrix();
      std::vector<double> right(matrix.size()), found(right), product(right), again(right);
      energy.assembly().scatter(gradient, right);
      linear::Multigrid<3> multigrid(host);
      multigrid.factor(matrix);
      CHECK(multigrid.levels() > 1);
      steps.push_back(multigrid.solve(right, 200, 1e-10, found));
      matrix.multiply(found, product, host);
      double residual = 0, size = 0;
      for (std::size_t i = 0; i < right.size(); ++i) {
        residual += (product[i] - right[i]) * (product[i] - right[i]);
        size += right[i] * right[i];
      }
      CHECK(residual < 1e-14 * size);
      // What it was used for does not matter.
      matrix = energy.matrix();
      multigrid.factor(matrix);
      multigrid.solve(right, 200, 1e-10, again);
      CHECK(again == found);
    }
    CAPTURE(steps[0]);
    CAPTURE(steps[1]);
    CHECK(steps[1] < 60);
    CHECK(steps[1] < 2 * steps[0]);
  }
}
