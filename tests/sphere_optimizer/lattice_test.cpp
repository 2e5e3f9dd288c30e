// How a library uses the optimizer from C++: a million quaternions on a lattice (d = 4), with the energy compiled into
// the loops, all at once and block by block. Nothing is allocated between the first step and the last.
#include <doctest/doctest.h>

#include "base/error.h"
#include "lattice.h"
#include "problems.h"
#include "sphere_optimizer/minimize.h"
#include "sphere_optimizer/relaxation.h"
#include "tests/capi/failing_allocations.h"

using namespace orbicube;
using namespace orbicube::test;
using namespace orbicube::sphere_optimizer;

namespace {

std::vector<double> lattice_start(std::size_t side) {
  std::vector<double> points = normal_numbers(4 * side * side * side, 12);
  for (std::size_t i = 0; i < points.size(); i += 4) {
    points[i] += 1.5;
    REQUIRE(normalize(FixedDimension<4>{}, &points[i]));
  }
  return points;
}

double lattice_energy(std::size_t side, std::span<const double> points) {
  std::vector<double> gradient(points.size());
  return LatticeEnergy(side, points).all(gradient);
}

}  // namespace

TEST_CASE("A million quaternions are minimized all at once without an allocation in the loop" *
          doctest::test_suite("long")) {
  constexpr std::size_t side = 100, count = side * side * side;
  const std::vector<double> start = lattice_start(side);
  const double before = lattice_energy(side, start);
  const base::Host host;
  Options options;
  options.memory = 4;
  options.max_evaluations = 12;
  Solver solver({count, 4}, options, start, host);
  const std::size_t allocations = allocation_count();
  const Result result = minimize(solver, [](std::span<const double> x, std::span<double> gradient) {
    return LatticeEnergy(side, x).all(gradient);
  });
  CHECK(allocation_count() == allocations);
  CHECK(result.evaluations == 12);
  CHECK(result.value == lattice_energy(side, solver.best_point()));
  CHECK(result.value < 0.2 * before);
  CHECK(length_error({count, 4}, solver.best_point()) <= 2);
}

TEST_CASE("A million quaternions are relaxed block by block without an allocation in the loop" *
          doctest::test_suite("long")) {
  constexpr std::size_t side = 100, count = side * side * side;
  for (const Order order : {Order::queue, Order::sweeps}) {
    std::vector<double> points = lattice_start(side);
    const LatticeEnergy energy(side, points);
    const double before = lattice_energy(side, points);
    const base::Host host;
    RelaxationOptions options;
    options.order = order;
    options.max_passes = 4;
    Relaxation relaxation({count, 4}, options, host.memory);
    const std::size_t allocations = allocation_count();
    relaxation.run(energy, points, host);
    CHECK(allocation_count() == allocations);
    CHECK(relaxation.result().steps == 4 * count);
    // A gradient and a value each as a rule, and one of each block at the end.
    CHECK(relaxation.result().evaluations < 2.5 * 4 * count + count);
    const double after = lattice_energy(side, points);
    CHECK(after < 0.02 * before);
    CHECK(relaxation.result().gain == doctest::Approx(before - after).epsilon(1e-10));
    CHECK(length_error({count, 4}, points) <= 2);
  }
}

TEST_CASE("Over-relaxed sweeps settle a lattice in a fraction of the passes") {
  constexpr std::size_t side = 16;
  const auto passes = [](Order order, double over_relaxation) {
    std::vector<double> points = lattice_start(side);
    RelaxationOptions options;
    options.order = order;
    options.over_relaxation = over_relaxation;
    const RelaxationResult result = relax(LatticeEnergy(side, points), points, options, base::Host());
    CHECK(result.stop == Stop::converged);
    CHECK(result.gradient_norm <= 1e-6);
    CHECK(lattice_energy(side, points) < 1e-6);
    return static_cast<double>(result.steps) / (side * side * side);
  };
  const double plain = passes(Order::sweeps, 1);
  // Plain sweeps damp the longest wave by 1 - (pi / side)^2 or so, over-relaxed ones by 1 - 2 pi / side.
  CHECK(plain > 300);
  CHECK(passes(Order::sweeps, 1.7) < 0.3 * plain);
  CHECK(passes(Order::sweeps, 0) < 0.3 * plain);
  CHECK(passes(Order::automatic, 0) < 0.4 * plain);
}

TEST_CASE("What the function throws ends the loop, which then goes on") {
  const Problem problem = thomson(5, 1);
  const base::Host host;
  Solver solver(problem.shape, {}, problem.start, host);
  int left = 3;
  const auto f = [&](std::span<const double> x, std::span<double> gradient) {
    if (left-- == 0) throw base::Error("internal", "on purpose");
    return problem.function(x, gradient);
  };
  CHECK_THROWS_AS(minimize(solver, f), base::Error);
  const Result result = minimize(solver, f);
  CHECK(result.stop == Stop::converged);
  CHECK(std::vector<double>(solver.best_point().begin(), solver.best_point().end()) == run(problem).x);
}
