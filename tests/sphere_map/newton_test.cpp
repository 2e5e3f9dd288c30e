// Newton's method on a whole level: its Hessian is right when it converges as Newton's method does.
#include "sphere_map/optimization/newton.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "mesh/search/predicates.h"
#include "shapes.h"
#include "sphere_map/sphere_map.h"

using namespace orbicube;
using namespace orbicube::sphere_map;

namespace {

// The whole surface as a level, with the map of sphere_map::compute to start from.
struct Problem {
  explicit Problem(const test::Surface& s)
      : surface(s),
        level(std::pmr::get_default_resource()),
        directions(compute(s.positions, s.triangles, {}, base::Host())) {
    energy.weights = {.angle = 0.1,
                      .area = 1,
                      .isometric = 0.05,
                      .quasi_conformal_1 = 0.2,
                      .quasi_conformal_2 = 1e-3,
                      .quasi_conformal_4 = 1e-3};
    const VertexRings rings(s.positions.size(), s.triangles, base::Host());
    for (Index v = 0; v < s.positions.size(); ++v) {
      level.vertices.push_back(v);
      place.push_back(v);
    }
    level.build(rings, s.positions, energy, base::Host(), base::ThreadPool(base::Host()));
  }

  double value() const { return level_energy(energy, level, directions, host, base::ThreadPool(host)); }
  double improve(int steps) {
    return newton(
        energy, level, {steps, 2000, 1e-15}, place, directions, [] {}, host, base::ThreadPool(host));
  }
  base::Host host;

  void shake(double size) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (Vector3& p : directions)
      p = (p + size * Vector3(normal(random), normal(random), normal(random))).normalized();
  }

  test::Surface surface;
  Energy energy;
  Level level;
  std::vector<Index> place;
  Array<Vector3> directions;
};

}  // namespace

TEST_CASE("Near the optimum a step takes away nearly all of what is left to gain") {
  Problem problem(test::creature(3));
  const double best = problem.improve(100);
  // Twice: from near, where the second derivatives decide, and from nearer.
  for (const double size : {1e-4, 1e-6}) {
    Problem shaken = problem;
    shaken.shake(size);
    const double before = shaken.value() - best;
    REQUIRE(before > 1e-14);
    const double after = shaken.improve(1) - best;
    // Systems are solved to a preconditioned residual of 0.1, which leaves about its square, .01 to .04 by how sums are
    // rounded; a Hessian that lacks a term leaves far more.
    CHECK(after < 0.1 * before);
  }
}

TEST_CASE("The point it ends at is a local optimum: no direction leads further down") {
  Problem problem(test::creature(3));
  const double best = problem.improve(100);
  CHECK(problem.value() == doctest::Approx(best).epsilon(1e-12));
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 50; ++trial) {
    Problem moved = problem;
    for (Vector3& p : moved.directions)
      p = (p + 1e-4 * Vector3(normal(random), normal(random), normal(random))).normalized();
    CHECK(moved.value() > best);
  }
}

TEST_CASE("From anywhere, energy falls and every triangle stays positive") {
  for (int levels = 1; levels < 5; ++levels) {
    Problem problem(test::creature(levels));
    problem.directions =
        compute(problem.surface.positions, problem.surface.triangles, {.method = Method::isometric}, base::Host());
    double value = problem.value();
    for (int step = 0; step < 5; ++step) {
      const double reached = problem.improve(1);
      CHECK(reached <= value);
      CHECK(problem.value() == doctest::Approx(reached).epsilon(1e-12));
      value = reached;
      for (const Triangle& t : problem.surface.triangles) {
        REQUIRE(mesh::orientation_from_origin(problem.directions[t[0]], problem.directions[t[1]],
                                              problem.directions[t[2]]) > 0);
      }
    }
  }
}

TEST_CASE("Large triangles, whose planes come near the origin, have the gradient that finite differences give") {
  // An octahedron is 0.58 from the origin. Its optimum by symmetry is the regular one; from a shaken start it is found.
  Problem problem(test::sphere(0));
  problem.shake(0.05);
  problem.improve(200);
  for (const Triangle& t : problem.surface.triangles) {
    for (int k = 0; k < 3; ++k) {
      CHECK(std::abs(problem.directions[t[static_cast<std::size_t>(k)]].dot(
                problem.directions[t[static_cast<std::size_t>((k + 1) % 3)]])) < 1e-4);
    }
  }
}
