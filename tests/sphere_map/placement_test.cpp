// A shape's map on the common sphere: exact signs, whatever the warp does.
#include "sphere_map/correspondence/placement.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "base/error.h"
#include "mesh/topology/topology.h"
#include "sphere_map/correspondence/landmark_flow.h"
#include "sphere_map/optimization/measure.h"
#include "uneven_maps.h"

using namespace orbicube;
using mesh::Triangle;
using mesh::Vector3;
using sphere_map::LandmarkFlow;

namespace {

// Landmarks along a circle that are turned against each other: much bending between them.
LandmarkFlow bent(double angle) {
  std::vector<Vector3> from, to;
  for (int i = 0; i < 8; ++i) {
    const double longitude = 0.785 * i, latitude = i % 2 == 0 ? 0.4 : -0.4;
    const auto at = [&](double turn) {
      return Vector3(std::cos(latitude) * std::cos(longitude + turn), std::cos(latitude) * std::sin(longitude + turn),
                     std::sin(latitude));
    };
    from.push_back(at(0));
    to.push_back(at(i % 2 == 0 ? angle : -angle));
  }
  return {from, to, base::Host()};
}

double area(std::span<const Vector3> x, std::span<const Triangle> triangles) {
  double sum = 0;
  for (const Triangle& t : triangles)
    sum += 0.5 * (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).norm();
  return sum;
}

}  // namespace

TEST_CASE("A map that a warp would flip in places is placed one to one, and its surface stays as it is") {
  std::size_t flipped = 0;
  for (const std::size_t size : {300U, 1500U}) {
    const test::MappedShape shape = test::mapped("creature", size);
    const auto& positions = shape.surface.positions;
    const auto& triangles = shape.surface.triangles;
    for (const double angle : {0.2, 0.6, 1.0, 1.4}) {
      CAPTURE(size);
      CAPTURE(angle);
      const LandmarkFlow flow = bent(angle);
      const auto move = [&](std::span<Vector3> directions) { flow.move(directions, base::Host()); };
      base::Array<Vector3> plain = shape.directions;
      move(plain);
      const std::size_t before = sphere_map::count_not_positive(triangles, plain);
      flipped += before;
      const auto placed = sphere_map::placed_one_to_one(positions, shape.directions, triangles, move, base::Host());
      REQUIRE(placed.has_value());
      CHECK(sphere_map::count_not_positive(placed->triangles, placed->directions) == 0);
      CHECK((before > 0) == (placed->added + placed->moved > 0));
      REQUIRE(placed->positions.size() == positions.size() + placed->added);
      REQUIRE(placed->directions.size() == placed->positions.size());
      CHECK_NOTHROW(
          mesh::require_closed_genus_zero(mesh::topology(placed->positions, placed->triangles, base::Host())));
      // Triangles cut along their edges: sums of areas in another order.
      CHECK(area(placed->positions, placed->triangles) == doctest::Approx(area(positions, triangles)).epsilon(1e-12));
      std::size_t elsewhere = 0;
      for (std::size_t v = 0; v < positions.size(); ++v) {
        CHECK(placed->positions[v] == positions[v]);
        elsewhere += placed->directions[v] != plain[v];
      }
      CHECK(elsewhere <= placed->moved);
    }
  }
  CHECK(flipped > 0);  // so that there was something to do
}

TEST_CASE("A map that is only turned keeps its triangles, on any number of threads") {
  const test::MappedShape shape = test::mapped("star", 2000);
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(2, Vector3(3, -1, 2).normalized()).toRotationMatrix();
  const auto move = [&](std::span<Vector3> directions) {
    for (Vector3& d : directions)
      d = (rotation * d).normalized();
  };
  base::Host one, four;
  one.thread_count = 1;
  four.thread_count = 4;
  const auto& s = shape.surface;
  const auto a = sphere_map::placed_one_to_one(s.positions, shape.directions, s.triangles, move, one);
  const auto b = sphere_map::placed_one_to_one(s.positions, shape.directions, s.triangles, move, four);
  REQUIRE(a.has_value());
  REQUIRE(b.has_value());
  CHECK(a->added == 0);
  CHECK(a->triangles == b->triangles);
  CHECK(std::memcmp(a->directions.data(), b->directions.data(), a->directions.size() * sizeof(Vector3)) == 0);
  CHECK_THROWS_AS(sphere_map::placed_one_to_one({}, shape.directions, s.triangles, move, one), base::Error);
}
