// Shapes of tetrahedra, against those that are known in closed form.
#include "mesh/search/tetrahedron_quality.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include "base/error.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::mesh;
using test::host;

namespace {

const double degrees_of_regular = std::acos(1.0 / 3) * 180 / std::acos(-1.0);
// What rounding in a few dozen operations on numbers of size 1 can add up to.
constexpr double rounding = 1e-13;

const std::vector<Vector3> regular = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};

TetrahedronShape shape(const std::vector<Vector3>& x) {
  return shape_of(x[0], x[1], x[2], x[3]);
}

}  // namespace

TEST_CASE("A regular tetrahedron has the shape that is known of it, at any size and place") {
  for (const double size : {1.0, 3.0, 1e-100, 1e100, 1e-160, 1e160}) {
    const Vector3 shift = size == 3 ? Vector3(1e3, -2e3, 5e2) : Vector3(Vector3::Zero());
    std::vector<Vector3> x = regular;
    for (Vector3& p : x)
      p = size * p + shift;
    const TetrahedronShape s = shape(x);
    const double tolerance = size == 3 ? 1e-11 : rounding;  // coordinates near 2e3 are rounded to 2e-13
    CHECK(std::abs(s.radius_ratio - 1) < tolerance);
    CHECK(std::abs(s.radius_edge - std::sqrt(6.0) / 4) < tolerance);
    CHECK(std::abs(s.min_edge_length / (size * std::sqrt(8.0)) - 1) < tolerance);
    CHECK(std::abs(s.max_edge_length / (size * std::sqrt(8.0)) - 1) < tolerance);
    for (const double angle : s.dihedral_angles)
      CHECK(std::abs(angle - degrees_of_regular) < 100 * tolerance);
    if (size < 1e100 && size > 1e-100) CHECK(std::abs(s.volume / (8.0 / 3 * size * size * size) - 1) < tolerance);
  }
}

TEST_CASE("The corner of a cube has three right angles, and its mirror image the same shape") {
  const std::vector<Vector3> corner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const bool mirrored : {false, true}) {
    std::vector<Vector3> x = corner;
    if (mirrored) std::swap(x[0], x[1]);
    TetrahedronShape s = shape(x);
    std::sort(s.dihedral_angles.begin(), s.dihedral_angles.end());
    const double flat = std::atan(std::sqrt(2.0)) * 180 / std::acos(-1.0);
    for (std::size_t i = 0; i < 6; ++i)
      CHECK(std::abs(s.dihedral_angles[i] - (i < 3 ? flat : 90)) < 100 * rounding);
    CHECK(std::abs(s.volume - 1.0 / 6) < rounding);
    CHECK(std::abs(s.radius_edge - std::sqrt(3.0) / 2) < rounding);
    // Inradius 1 / (3 + sqrt 3), circumradius sqrt(3) / 2.
    CHECK(std::abs(s.radius_ratio - 3 / (3 + std::sqrt(3.0)) * 2 / std::sqrt(3.0)) < rounding);
  }
}

TEST_CASE("Shapes do not depend on the order of corners, on place, or on rotation") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int run = 0; run < 50; ++run) {
    std::vector<Vector3> x(4);
    for (Vector3& p : x)
      p = {coordinate(random), coordinate(random), coordinate(random)};
    const TetrahedronShape before = shape(x);
    if (before.radius_ratio < 0.01) continue;  // flat ones lose digits
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(run, Vector3(1, 2, run).normalized()));
    std::vector<Vector3> y;
    for (const std::size_t i : {2U, 0U, 3U, 1U})
      y.push_back(turn * x[i] + Vector3(1, 2, 3));
    const TetrahedronShape after = shape(y);
    CHECK(after.radius_ratio == doctest::Approx(before.radius_ratio).epsilon(1e-9));
    CHECK(after.radius_edge == doctest::Approx(before.radius_edge).epsilon(1e-9));
    CHECK(after.volume == doctest::Approx(before.volume).epsilon(1e-9));
    CHECK(std::accumulate(after.dihedral_angles.begin(), after.dihedral_angles.end(), 0.0) ==
          doctest::Approx(std::accumulate(before.dihedral_angles.begin(), before.dihedral_angles.end(), 0.0)));
  }
}

TEST_CASE("Flat and collapsed tetrahedra have finite figures where there are any") {
  const std::vector<Vector3> flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const TetrahedronShape s = shape(flat);
  CHECK(s.volume == 0);
  CHECK(s.radius_ratio == 0);
  CHECK(std::isinf(s.radius_edge));
  CHECK(s.min_edge_length == doctest::Approx(1));
  const TetrahedronShape point = shape({flat[0], flat[0], flat[0], flat[0]});
  CHECK(point.max_edge_length == 0);
  CHECK(point.radius_ratio == 0);
}

TEST_CASE("The report counts signs exactly, adds volumes up and names the worst") {
  std::vector<Vector3> x = regular;
  x.push_back({3, 3, 3});
  x.push_back({1, 1, std::nextafter(1.0, 2.0)});  // a hair off vertex 0
  const std::vector<Tetrahedron> cells = {{0, 1, 3, 2}, {0, 1, 2, 3}, {4, 1, 2, 3},
                                          {4, 1, 3, 2}, {0, 4, 5, 1}, {0, 0, 1, 2}};
  const TetrahedronQuality q = tetrahedron_quality(x, cells, host);
  CHECK(q.tetrahedra == 6);
  CHECK(q.positive + q.flat + q.inverted == 6);
  CHECK(q.flat == 1);
  CHECK(q.positive == q.inverted + 1);  // two pairs of mirror images, and the thin one
  CHECK(std::abs(q.volume) < 1e-12);    // pairs cancel; the thin one has 1e-16
  CHECK(q.min_volume == -q.max_volume);
  std::size_t angles = 0, ratios = 0;
  for (const std::size_t n : q.dihedral_histogram)
    angles += n;
  for (const std::size_t n : q.radius_ratio_histogram)
    ratios += n;
  CHECK(angles == 36);
  CHECK(ratios == 6);
  CHECK(q.dihedral_histogram[7] >= 12);  // those of the two regular ones, 70.5 degrees
  CHECK(q.min_radius_ratio == doctest::Approx(-1));
  CHECK(std::isinf(q.max_radius_edge));
  CHECK(shape_of(x[cells[q.worst][0]], x[cells[q.worst][1]], x[cells[q.worst][2]], x[cells[q.worst][3]]).radius_ratio ==
        doctest::Approx(1));
}

TEST_CASE("The report refuses vertices that do not exist, and is empty without tetrahedra") {
  const std::vector<Tetrahedron> cells = {{0, 1, 2, 4}};
  CHECK_THROWS_AS(tetrahedron_quality(regular, cells, host), base::Error);
  CHECK(tetrahedron_quality(regular, {}, host).max_volume == 0);
}
