// One polycube for several shapes: maps of space through points, the sum of energies, drawings that follow a map.
#include "polycube/domain/common_polycube.h"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <random>

#include "blocks.h"
#include "mesh/search/nearest.h"
#include "polycube/domain/shape_copies.h"
#include "polycube/layout/drawn_construction.h"
#include "shapes.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::host;
using test::shape;

namespace {

std::vector<Vector3> random_points(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Vector3> result;
  const auto number = [&] { return static_cast<double>(random() % 100000) / 50000 - 1; };
  for (std::size_t i = 0; i < count; ++i) {
    const double x = number(), y = number(), z = number();
    result.emplace_back(x, y, z);
  }
  return result;
}

SurfaceMap certified(const mesh::Mesh& in_space, const mesh::Mesh& on_polycube) {
  SurfaceMap map;
  map.positions = in_space.positions;
  map.polycube = on_polycube.positions;
  map.triangles = in_space.triangles;
  set_unrefined(map);
  REQUIRE(certify(map, host).valid());
  return map;
}

// A creature that leans and has grown, as another of its kind might stand beside it.
mesh::Mesh leaning(const mesh::Mesh& m) {
  mesh::Mesh result = m;
  for (Vector3& p : result.positions)
    p = Vector3(1.2 * p[0] + 0.15 * p[1] * p[1], 0.9 * p[1] + 0.05 * p[2], 1.1 * p[2] + 0.1 * std::sin(2 * p[1]));
  return result;
}

}  // namespace

TEST_CASE("A scattered map goes through its points, keeps affine maps, and has the derivative of differences") {
  const std::vector<Vector3> points = random_points(30, 1), images = random_points(30, 2);
  const ScatteredMap map(points, images, 0, host);
  for (std::size_t i = 0; i < points.size(); ++i)
    CHECK((map(points[i]) - images[i]).norm() < 1e-10);
  for (const Vector3& x : random_points(10, 3)) {
    const Eigen::Matrix3d derivative = map.derivative(x);
    for (int k = 0; k < 3; ++k) {
      const double step = 1e-6;
      const Vector3 difference = (map(x + step * Vector3::Unit(k)) - map(x - step * Vector3::Unit(k))) / (2 * step);
      CHECK((derivative.col(k) - difference).norm() < 1e-7 * (1 + derivative.norm()));
    }
  }
  Eigen::Matrix3d linear;
  linear << 1, 2, 0.5, -1, 0.3, 2, 0.2, 0.1, -3;
  const Vector3 shift(7, -2, 100);
  std::vector<Vector3> moved;
  for (const Vector3& p : points)
    moved.push_back(linear * p + shift);
  const ScatteredMap affine(points, moved, 0, host);
  for (const Vector3& x : random_points(10, 4))
    CHECK((affine(3 * x) - linear * (3 * x) - shift).norm() < 1e-9);
  // Points in a plane say nothing about the rest; the same point twice is fine; no point at all is the identity.
  const std::vector<Vector3> flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 0}};
  const std::vector<Vector3> lifted = {{0, 0, 5}, {1, 0, 5}, {0, 1, 5}, {1, 1, 5}, {9, 9, 9}};
  CHECK((ScatteredMap(flat, lifted, 0, host)(Vector3(3, -2, 4)) - Vector3(3, -2, 9)).norm() < 1e-10);
  CHECK(ScatteredMap({}, {}, 0, host)(Vector3(1, 2, 3)) == Vector3(1, 2, 3));
}

TEST_CASE("A shape is bent to another of its kind, and pairs of points are met") {
  const mesh::Mesh from = shape("creature", 1500), to = leaning(from);
  const auto distance = [&](const ScatteredMap& map) {
    double sum = 0;
    for (std::size_t v = 0; v < from.positions.size(); ++v)
      sum += (map(from.positions[v]) - to.positions[v]).norm();
    return sum / static_cast<double>(from.positions.size());
  };
  const ScatteredMap none({}, {}, 0, host);
  const ScatteredMap bend = bend_shape({from.positions, from.triangles}, {to.positions, to.triangles}, {}, host);
  // Each vertex comes near to its own counterpart, of which the bend knows nothing.
  CHECK(distance(bend) < 0.3 * distance(none));
  std::vector<PointPair> pairs;
  for (std::size_t v = 0; v < from.positions.size(); v += from.positions.size() / 6)
    pairs.push_back({from.positions[v], to.positions[v]});
  const ScatteredMap with = bend_shape({from.positions, from.triangles}, {to.positions, to.triangles}, pairs, host);
  CHECK(distance(with) < 0.3 * distance(none));
  for (const PointPair& pair : pairs)
    CHECK((with(pair.first) - pair.second).norm() < 0.05);
}

TEST_CASE("The best proportions for one map are those that it has alone") {
  const mesh::Mesh cube = test::blocks(test::box_without({2, 2, 2}));
  mesh::Mesh box = cube;
  for (Vector3& p : box.positions)
    p[0] *= 3;
  SurfaceMap one = certified(cube, box), alone = one;
  SurfaceMap* const pointer = &one;
  const CommonDomain common = optimize_domain({&pointer, 1}, {}, host);
  const OptimalDomain single = optimize_domain(alone, {}, host);
  CHECK(common.energies.back() == doctest::Approx(single.energies.back()).epsilon(1e-12));
  CHECK(common.converged);
  for (std::size_t v = 0; v < one.polycube.size(); ++v)
    CHECK((one.polycube[v] - alone.polycube[v]).norm() < 1e-6);
}

TEST_CASE("Two shapes share the proportions that minimize the sum of their energies") {
  const mesh::Mesh cube = test::blocks(test::box_without({2, 2, 2}));
  mesh::Mesh tall = cube, wide = cube;
  for (Vector3& p : tall.positions)
    p[2] *= 2;
  for (Vector3& p : wide.positions)
    p[0] *= 2;
  SurfaceMap first = certified(tall, cube), second = certified(wide, cube);
  const std::vector<SurfaceMap*> maps = {&first, &second};
  const double before = energy_of(first, {}, host) + energy_of(second, {}, host);
  const CommonDomain found = optimize_domain(maps, {}, host);
  CHECK(found.converged);
  CHECK(std::is_sorted(found.energies.rbegin(), found.energies.rend()));
  CHECK(found.energies.front() == doctest::Approx(before).epsilon(1e-13));
  const auto sum = [&] { return energy_of(first, {}, host) + energy_of(second, {}, host); };
  CHECK(found.energies.back() == doctest::Approx(sum()).epsilon(1e-13));
  CHECK(first.polycube == second.polycube);
  // Both shapes are the same but for x and z, so is what suits both.
  Vector3 low = first.polycube[0], high = low;
  for (const Vector3& p : first.polycube) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector3 size = high - low;
  CHECK(size[0] == doctest::Approx(size[2]).epsilon(1e-6));
  CHECK(size[1] < 0.95 * size[0]);
  // A least sum: no change of one side makes it less.
  const SurfaceMap best_first = first, best_second = second;
  const double least = sum();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double factor : {0.98, 1.02}) {
      first = best_first;
      second = best_second;
      for (SurfaceMap* map : maps)
        for (Vector3& p : map->polycube)
          p[axis] *= factor;
      CHECK(sum() > least);
    }
  }
  first = best_first;
  first.polycube[0] *= 1.0;
  for (Vector3& p : first.polycube)
    p[0] += 1;
  CHECK_THROWS(optimize_domain(maps, {}, host));  // another polycube
  CHECK_THROWS(optimize_domain(std::span<SurfaceMap* const>(), {}, host));
  CHECK_THROWS(optimize_domain(maps, {.area_weight = -1}, host));
}

TEST_CASE("Shapes of a kind get one polycube that suits each nearly as well as its own" * doctest::test_suite("long")) {
  const mesh::Mesh first = shape("creature", 1500), second = leaning(first);
  const std::vector<SurfaceSpan> shapes = {{first.positions, first.triangles}, {second.positions, second.triangles}};
  const CommonPolycube common =
      construct_common(shapes, {.construction = {.corners = 24}, .domain = {}, .landmarks = {}}, host);
  REQUIRE(common.maps.size() == 2);
  CHECK(common.base < 2);
  CHECK(common.tried >= 2);
  CHECK(std::is_sorted(common.energies.rbegin(), common.energies.rend()));
  double sum = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    SurfaceMap map = common.maps[i];
    const Certificate certificate = certify(map, host);
    CHECK(certificate.valid());
    CHECK(certificate.corners == common.graph.corners.size());
    sum += energy_of(map, {}, host);
    // One polycube, whatever the triangles.
    const PatchGraph graph = make_patch_graph(map, host);
    for (const Vector3& c : common.graph.corners)
      CHECK(std::find(graph.corners.begin(), graph.corners.end(), c) != graph.corners.end());
    CHECK(std::isfinite(common.own_energies[i]));
  }
  CHECK(sum == doctest::Approx(common.energies.back()).epsilon(1e-12));
  CHECK(sum < 1.1 * (common.own_energies[0] + common.own_energies[1]));
}

TEST_CASE("Copies of a shape get its very map, also turned, moved and scaled ones") {
  const mesh::Mesh first = shape("l-shape", 400);
  mesh::Mesh turned = first;
  for (Vector3& p : turned.positions)
    p = 3 * Vector3(0.6 * p[0] - 0.8 * p[1], 0.8 * p[0] + 0.6 * p[1], p[2]) + Vector3(1, 2, 3);
  mesh::Mesh longer = first;
  for (Vector3& p : longer.positions)
    p[0] *= 1.5;
  const std::vector<SurfaceSpan> shapes = {{first.positions, first.triangles},
                                           {first.positions, first.triangles},
                                           {turned.positions, turned.triangles},
                                           {longer.positions, longer.triangles}};
  CHECK(originals_of(shapes, host) == std::vector<std::size_t>{0, 0, 0, 3});
  const CommonPolycube common = construct_common(std::span(shapes).first(3), {}, host);
  for (std::size_t i = 1; i < 3; ++i) {
    CHECK(common.maps[i].polycube == common.maps[0].polycube);
    CHECK(common.maps[i].triangles == common.maps[0].triangles);
    for (std::size_t v = 0; v < first.positions.size(); ++v)
      CHECK(common.maps[i].positions[v] == Vector3(shapes[i].positions[v]));
  }
}

TEST_CASE("A given polycube is shared as it is, and at better proportions and corners where that is requested") {
  const mesh::Mesh first = shape("l-shape", 400);
  mesh::Mesh longer = first;
  for (Vector3& p : longer.positions)
    p[0] *= 1.5;
  const std::vector<SurfaceSpan> shapes = {{first.positions, first.triangles}, {longer.positions, longer.triangles}};
  const SurfaceMap own = construct(first.positions, first.triangles, {}, host).made.map;
  const PatchGraph graph = make_patch_graph(own, host);
  CommonPolycubeOptions options;
  options.target = {&graph, 0, {}};
  const CommonPolycube kept = construct_common(shapes, options, host);
  options.proportions = true;
  options.corners = true;
  const CommonPolycube better = construct_common(shapes, options, host);
  for (const CommonPolycube* common : {&kept, &better})
    for (SurfaceMap map : common->maps)
      CHECK(certify(map, host).valid());
  for (const Vector3& corner : kept.graph.corners)
    CHECK(std::find(graph.corners.begin(), graph.corners.end(), corner) != graph.corners.end());
  CHECK(better.energies.back() <= kept.energies.back());
  options.target.genus = 1;
  CHECK_THROWS_WITH(construct_common(shapes, options, host), doctest::Contains("genus"));
}

TEST_CASE("Shapes of different genus have no polycube in common") {
  const mesh::Mesh ball = shape("sphere", 600), ring = shape("torus", 600);
  const std::vector<SurfaceSpan> shapes = {{ball.positions, ball.triangles}, {ring.positions, ring.triangles}};
  CHECK_THROWS_WITH(construct_common(shapes, {}, host), doctest::Contains("no polycube in common"));
  CHECK_THROWS(construct_common({}, {}, host));
}
