// What a polycube has no room for, and boxes for it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "blocks.h"
#include "polycube/labels/label_construction.h"
#include "polycube/map/certificate.h"
#include "polycube/map/distorted_regions.h"
#include "shapes.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::blocks;
using test::box_without;
using test::host;

namespace {

constexpr int side = 18;

// A protrusion on the upper face of a cube, of a cone's form.
double height(const Vector3& p, double x, double y, double radius, double length) {
  return p.z() < side ? 0 : length * std::max(0.0, 1 - std::hypot(p.x() - x, p.y() - y) / radius);
}

// The map of a cube with two protrusions to the cube.
SurfaceMap horned(double long_one, double short_one) {
  const mesh::Mesh cube = blocks(box_without({side, side, side}));
  SurfaceMap map;
  map.polycube = cube.positions;
  map.triangles = cube.triangles;
  for (const Vector3& p : cube.positions)
    map.positions.push_back(p + Vector3(0, 0, height(p, 4, 4, 3, long_one) + height(p, 13, 13, 2.1, short_one)));
  set_unrefined(map);
  return map;
}

}  // namespace

TEST_CASE("Protrusions on a face are distorted regions, with their tips, and the cube below is none") {
  const SurfaceMap map = horned(12, 8);
  const Surface surface(Array<Vector3>(map.positions), Array<Triangle>(map.triangles), host);
  const DistortedRegions regions = find_distorted_regions(surface, map, host);
  REQUIRE(regions.count == 2);
  for (std::size_t i = 0; i < map.triangles.size(); ++i) {
    const mesh::Triangle& t = map.triangles[i];
    const Vector3 centre = (map.polycube[t[0]] + map.polycube[t[1]] + map.polycube[t[2]]) / 3;
    const auto lifted = [&](double x, double y, double radius) {
      return std::all_of(t.begin(), t.end(), [&](Index v) { return height(map.polycube[v], x, y, radius, 1) > 0; });
    };
    if (lifted(4, 4, 3)) CHECK(regions.of_triangle[i] == 0);
    if (lifted(13, 13, 2.1)) CHECK(regions.of_triangle[i] == 1);
    if (centre.z() < side) CHECK(regions.of_triangle[i] == no_index);
  }
}

TEST_CASE("An isometry has no distorted regions, and low hills are none") {
  for (const double length : {0.0, 0.5}) {
    const SurfaceMap map = horned(length, length);
    const Surface surface(Array<Vector3>(map.positions), Array<Triangle>(map.triangles), host);
    CHECK(find_distorted_regions(surface, map, host).count == 0);
  }
}

TEST_CASE("Spikes of a star get boxes of their own" * doctest::test_suite("long")) {
  const mesh::Mesh star = test::shape("star", 3000);
  Construction made = construct_by_labels(star.positions, star.triangles, {}, host);
  CHECK(made.certificate.valid());
  CHECK(certify(made.map, host).valid());
  // Labeled in one piece alone its best polycube has 42 corners and a product of 1.60.
  CHECK(made.certificate.corners > 42);
  CHECK(made.distortion.angle_weighted_mean * made.distortion.area_weighted_mean < 1.5);
}

TEST_CASE("More corners than preferred are had only where that is worth it" * doctest::test_suite("long")) {
  const mesh::Mesh star = test::shape("star", 1000);
  const auto corners = [&](std::size_t preferred) {
    return construct_by_labels(star.positions, star.triangles, {.preferred_corners = preferred}, host)
        .certificate.corners;
  };
  const std::size_t any = corners(0), few = corners(8);
  CHECK(few <= any);
  // Much better than what has eight corners.
  CHECK(few > 8);
}
