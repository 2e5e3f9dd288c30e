// Frames and axes that are given with a weight: optima that are known, limits, and a minimum of the sum of both
// energies.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "frame_field/frame_field.h"
#include "frame_field/smoothing/energy.h"
#include "quaternion/frame_distance.h"
#include "solids.h"

using namespace orbicube;
using namespace orbicube::frame_field;
using test::computed;

TEST_CASE("One tetrahedron follows a pull, and the mean of two") {
  const test::Solid solid{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}};
  const Quaternion q = turned({1, 0, 0, 0}, {0, 0, 1}, 0.3);
  const Quaternion back = turned({1, 0, 0, 0}, {0, 0, 1}, -0.1);
  const std::vector<GivenFrame> one = {{0, q, 0.5}}, two = {{0, q, 2}, {0, back, 2}};
  const Options options{.start = Start::harmonic, .align_boundary = false, .relative_gain = 1e-12};
  CHECK(quaternion::symmetric_distance(computed(solid, options, {.frames = one, .axes = {}}).field[0], q) < 1e-4);
  const Outcome mean = computed(solid, options, {.frames = two, .axes = {}});
  CHECK(quaternion::symmetric_distance(mean.field[0], turned({1, 0, 0, 0}, {0, 0, 1}, 0.1)) < 1e-4);
  CHECK(mean.energy == 0);  // of the faces alone
}

TEST_CASE("A heavy pull is followed like a constraint, a light one hardly moves the field") {
  const test::Solid solid = test::cubes(5, 5, 5);
  const Quaternion wanted = turned({1, 0, 0, 0}, {0, 0, 1}, 0.5);
  const Index middle = static_cast<Index>(solid.tetrahedra.size() / 2);
  const auto off = [&](double weight, Start start) {
    const std::vector<GivenFrame> frames = {{middle, wanted, weight}};
    return quaternion::symmetric_distance(
        computed(solid, {.start = start}, {.frames = frames, .axes = {}}).field[middle], wanted);
  };
  for (const Start start : {Start::automatic, Start::harmonic}) {
    CHECK(off(1e4, start) < 1e-3);
    CHECK(off(1, start) > 0.05);
    CHECK(off(1, start) < 0.5);
    CHECK(off(1e-4, start) == doctest::Approx(0.5).epsilon(1e-2));
  }
}

TEST_CASE("With pulls the smoothed field is a minimum of both energies together") {
  const test::Solid solid = test::ball(5);
  std::mt19937_64 random(12);
  std::vector<GivenFrame> frames;
  std::vector<GivenAxis> axes;
  for (Index t = 0; t < solid.tetrahedra.size(); t += 11) {
    frames.push_back({t, test::random_rotation(random), 0.7});
    axes.push_back({t + 1, quaternion::rotate(test::random_rotation(random), {0, 0, 1}), 1.3});
  }
  axes.push_back({0, {0, 0, 1}});  // held
  const Outcome outcome =
      computed(solid, {.start = Start::harmonic, .relative_gain = 1e-12}, {.frames = frames, .axes = axes});
  const base::Host host;
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
  const DualGraph graph = make_dual_graph(solid.positions, connectivity, Weighting::uniform, host);
  const Constraints constraints = make_constraints(graph, solid.positions, connectivity, true, frames, axes, host);
  CHECK(constraints.pulls.size() == frames.size() + axes.size() - 1);
  Field field = by_node(graph, outcome.field, host.memory);
  for (Index i = 0; i < graph.size(); ++i) {
    if (!constraints.is_free(i)) continue;
    const Quaternion q = field[i];
    const auto around = [&](const Vector& axis, double angle) {
      const Quaternion moved = turned(q, axis, angle);
      double sum = 0;
      for (const Index other : graph.others[i])
        sum += other == i ? 0 : quaternion::symmetric_sine_square(moved, field[other]);
      for (const Pull& pull : constraints.pulls_at(i))
        sum += worth(pull, moved);
      return sum;
    };
    for (const Vector& axis : {Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}})
      CHECK(std::abs(around(axis, 1e-4) - around(axis, -1e-4)) / 2e-4 < 1e-4);
  }
}

TEST_CASE("An axis that is pulled at comes nearer to its direction with the weight") {
  const test::Solid solid = test::cubes(6, 4, 4);
  const Vector wanted = {std::sin(0.4), 0, std::cos(0.4)};
  const Index middle = static_cast<Index>(solid.tetrahedra.size() / 2 + 3);
  double last = 0.39;
  for (const double weight : {1.0, 4.0, 100.0}) {
    const std::vector<GivenAxis> axes = {{middle, wanted, weight}};
    const Outcome outcome = computed(solid, {.start = Start::harmonic}, {.frames = {}, .axes = axes});
    const Vector local = quaternion::rotate(quaternion::conjugate(outcome.field[middle]), wanted);
    const double angle = std::acos(std::min(1.0, std::max({std::abs(local.x), std::abs(local.y), std::abs(local.z)})));
    CHECK(angle < last);
    last = angle;
  }
  CHECK(last < 0.02);
}
