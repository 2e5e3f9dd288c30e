// The graph's equations against dense ones, its hierarchy and its order.
#include "frame_field/graph/graph_solver.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <random>
#include <set>

#include "base/error.h"
#include "solids.h"

using namespace orbicube;
using namespace orbicube::frame_field;

namespace {

// Solvers keep a reference to their host.
const base::Host& quiet_host() {
  static const base::Host host;
  return host;
}

DualGraph graph_of(const test::Solid& solid, Weighting weighting = Weighting::uniform) {
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, quiet_host());
  return make_dual_graph(solid.positions, connectivity, weighting, quiet_host());
}

}  // namespace

TEST_CASE("The dual graph has a link for each inner face from both sides, with the same weight") {
  const test::Solid solid = test::shaken(test::cubes(4, 3, 3), 0.1);
  for (const Weighting weighting : {Weighting::uniform, Weighting::geometric}) {
    const DualGraph graph = graph_of(solid, weighting);
    REQUIRE(graph.size() == solid.tetrahedra.size());
    CHECK(std::set(graph.tetrahedron.begin(), graph.tetrahedron.end()).size() == graph.size());
    std::size_t ends = 0;
    double sum = 0;
    for (Index i = 0; i < graph.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const Index other = graph.others[i][k];
        sum += static_cast<double>(graph.weights[i][k]);
        if (other == i) {
          CHECK(graph.weights[i][k] == 0);
          continue;
        }
        ++ends;
        bool back = false;
        for (std::size_t l = 0; l < 4; ++l)
          back = back || (graph.others[other][l] == i && graph.weights[other][l] == graph.weights[i][k]);
        CHECK(back);
      }
    }
    CHECK(ends == 2 * graph.links);
    CHECK(sum == doctest::Approx(static_cast<double>(ends)).epsilon(1e-6));
  }
}

TEST_CASE("The order of the nodes does not depend on the order of the mesh") {
  const test::Solid solid = test::shaken(test::cubes(4, 4, 4), 0.1);
  test::Solid other = solid;
  std::vector<Index> order(solid.tetrahedra.size());
  for (Index t = 0; t < order.size(); ++t)
    order[t] = t;
  std::shuffle(order.begin(), order.end(), std::mt19937(3));
  for (Index t = 0; t < order.size(); ++t)
    other.tetrahedra[t] = solid.tetrahedra[order[t]];
  const DualGraph a = graph_of(solid), b = graph_of(other);
  for (Index i = 0; i < a.size(); ++i)
    CHECK(a.tetrahedron[i] == order[b.tetrahedron[i]]);
}

TEST_CASE("Coarse graphs keep all nodes and all weight between their groups") {
  const DualGraph graph = graph_of(test::cubes(6, 5, 7));
  const auto levels = make_hierarchy(graph, 20, quiet_host());
  REQUIRE(levels.size() >= 2);
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const CoarseGraph& level = levels[l];
    float members = 0;
    for (Index g = 0; g < level.size(); ++g) {
      members += level.members[g];
      float total = 0;
      for (Index n = level.begin[g]; n < level.begin[g + 1]; ++n) {
        total += level.weight[n];
        CHECK(level.other[n] != g);
      }
      CHECK(total == level.total_weight[g]);
    }
    CHECK(members == static_cast<float>(graph.size()));
    CHECK(3 * level.size() < (l == 0 ? graph.size() : levels[l - 1].size()));
  }
  float between = 0;
  for (Index i = 0; i < graph.size(); ++i) {
    for (std::size_t k = 0; k < 4; ++k)
      between += levels[0].group[i] != levels[0].group[graph.others[i][k]] ? graph.weights[i][k] : 0;
  }
  float kept = 0;
  for (const float w : levels[0].weight)
    kept += w;
  CHECK(kept == between);
}

TEST_CASE("Solutions are those of the dense equations, with nodes that move in some directions only") {
  const DualGraph graph = graph_of(test::cubes(3, 3, 4));
  const auto n = static_cast<Eigen::Index>(graph.size());
  const auto levels = make_hierarchy(graph, 10, quiet_host());
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  using Solver = GraphSolver<3>;
  std::vector<Solver::Tangent> tangents;
  for (Index i = 0; i < graph.size(); i += 3) {
    Solver::Tangent tangent{i, {}};
    const Vector3 d =
        i % 2 == 0 ? Vector3::Zero() : Vector3(normal(random), normal(random), normal(random)).normalized();
    for (int c = 0; c < 3; ++c)
      tangent.direction[0].at[static_cast<std::size_t>(c)] = static_cast<float>(d[c]);
    tangents.push_back(tangent);
  }
  for (const float mass : {0.0F, 0.01F, 1.0F}) {
    // The matrix, and the projection onto what may move.
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * n, 3 * n), movable = Eigen::MatrixXd::Identity(3 * n, 3 * n);
    for (Index i = 0; i < graph.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        const double w = static_cast<double>(graph.weights[i][k]);
        matrix.block<3, 3>(3 * i, 3 * i) += w * Eigen::Matrix3d::Identity();
        matrix.block<3, 3>(3 * i, 3 * graph.others[i][k]) -= w * Eigen::Matrix3d::Identity();
      }
      matrix.block<3, 3>(3 * i, 3 * i) += static_cast<double>(mass) * Eigen::Matrix3d::Identity();
    }
    for (const auto& tangent : tangents) {
      const auto& d = tangent.direction[0].at;
      const Vector3 v(static_cast<double>(d[0]), static_cast<double>(d[1]), static_cast<double>(d[2]));
      movable.block<3, 3>(3 * tangent.node, 3 * tangent.node) = v * v.transpose();
    }
    Array<Solver::Value> right(graph.size()), x(graph.size());
    Eigen::VectorXd b(3 * n);
    for (Index i = 0; i < graph.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        right[i].at[c] = static_cast<float>(normal(random));
        b[static_cast<Eigen::Index>(3 * i + c)] = static_cast<double>(right[i].at[c]);
      }
    }
    const Eigen::MatrixXd constrained =
        movable * matrix * movable + (Eigen::MatrixXd::Identity(3 * n, 3 * n) - movable);
    const Eigen::VectorXd expected = constrained.ldlt().solve(movable * b);
    Array<float> masses(graph.size(), mass);
    Solver solver(graph, levels, tangents, quiet_host());
    Solver::Equation equation{.tolerance = 1e-6, .phase = "test"};
    if (mass > 0) equation.mass = masses;
    const auto outcome = solver.solve(equation, right, x);
    CHECK(outcome.reduction < 1e-6);
    double error = 0;
    for (Index i = 0; i < graph.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c)
        error =
            std::max(error, std::abs(static_cast<double>(x[i].at[c]) - expected[static_cast<Eigen::Index>(3 * i + c)]));
    }
    // Storage has 24 bits, and the smallest eigenvalue of such a graph is some hundredths.
    CHECK(error < 2e-4 * expected.cwiseAbs().maxCoeff());
  }
}

TEST_CASE("Iterations hardly grow with the mesh") {
  std::vector<std::uint32_t> iterations;
  for (const Index size : {8U, 16U}) {
    const test::Solid solid = test::cubes(size, size, size);
    const DualGraph graph = graph_of(solid);
    const auto levels = make_hierarchy(graph, 60, quiet_host());
    // The layer that touches one corner is fixed.
    std::vector<GraphSolver<9>::Tangent> tangents;
    for (Index i = 0; i < graph.size() / 50; ++i)
      tangents.push_back({i, {}});
    Array<GraphSolver<9>::Value> x(graph.size()), right(graph.size());
    for (Index i = 0; i < graph.size(); ++i)
      right[i].at[i % 9] = i % 2 == 0 ? 1.0F : -0.5F;
    GraphSolver<9> solver(graph, levels, tangents, quiet_host());
    iterations.push_back(solver.solve({.tolerance = 1e-4, .phase = "test"}, right, x).iterations);
  }
  MESSAGE("iterations for 3072 and 24576 nodes: " << iterations[0] << ", " << iterations[1]);
  CHECK(iterations[1] <= 1.5 * iterations[0]);
  CHECK(iterations[1] < 40);
}
