// Figures of hexahedral meshes: distances of insides of triangles, volumes, at any size; pieces and the whole.
#include "hexmesh/certificate/hex_figures.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "hexmesh/certificate/hausdorff_distance.h"
#include "hexmesh/strategies/hex_pieces.h"
#include "tests/volume_map/box_surface.h"
#include "volume_map/input/solid_pieces.h"
#include "volume_map/input/working_space.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using namespace orbicube::volume_map;
using mesh::Triangle;

namespace {

struct MadeSurface : volume_map::test::BoxSurface {
  // A rod of `sides` sides and radius 1 along z.
  void add_rod(int sides, double length) {
    const auto n = static_cast<Index>(sides);
    for (Index k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * k / sides;
      positions.emplace_back(std::cos(angle), std::sin(angle), 0);
      positions.emplace_back(std::cos(angle), std::sin(angle), length);
    }
    for (Index k = 0; k < n; ++k) {
      const Index a = 2 * k, b = 2 * ((k + 1) % n);
      triangles.push_back({a, b, a + 1});
      triangles.push_back({b, b + 1, a + 1});
      if (k == 0 || k + 1 == n) continue;
      triangles.push_back({0, b, a});
      triangles.push_back({1, a + 1, b + 1});
    }
  }

  void turn(const Eigen::AngleAxisd& rotation) {
    for (Vector3& p : positions)
      p = rotation * p;
  }
};

double distance(const MadeSurface& a, const MadeSurface& b, double tolerance) {
  return hausdorff_distance(a.positions, a.triangles, b.positions, b.triangles, tolerance, base::Host());
}

struct Box {
  std::vector<Vector3> positions;
  std::vector<Hexahedron> hexahedra = {{0, 1, 2, 3, 4, 5, 6, 7}};

  explicit Box(const Vector3& size) {
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      positions.push_back(size.cwiseProduct(Vector3(x, y, 0)));
    for (std::size_t i = 0; i < 4; ++i)
      positions.push_back(positions[i] + Vector3(0, 0, size[2]));
  }
};

// Around the z axis, with radii 1 and `thickness`, and z times `flattening`.
MadeSurface ring(double thickness, double flattening) {
  MadeSurface result;
  constexpr Index around = 64, across = 8;
  for (Index i = 0; i < around; ++i) {
    for (Index k = 0; k < across; ++k) {
      const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * k / across;
      const double r = 1 + thickness * std::cos(b);
      result.positions.emplace_back(r * std::cos(a), r * std::sin(a), flattening * thickness * std::sin(b));
      const Index j = (i + 1) % around, l = (k + 1) % across;
      result.triangles.push_back({i * across + k, j * across + k, j * across + l});
      result.triangles.push_back({i * across + k, j * across + l, i * across + l});
    }
  }
  return result;
}

}  // namespace

TEST_CASE("The Hausdorff distance is found inside of triangles") {
  // Slivers along the sides of a triangle: the farthest point is the center of its inscribed circle.
  MadeSurface whole, sides;
  const Vector3 a(0, 0, 0), b(4, 0, 0), c(0, 3, 0), up(0, 0, 1e-9);
  whole.add_triangle(a, b, c);
  sides.add_triangle(a, b, 0.5 * (a + b) + up);
  sides.add_triangle(b, c, 0.5 * (b + c) + up);
  sides.add_triangle(c, a, 0.5 * (c + a) + up);
  for (const double tolerance : {0.1, 0.005, 1e-4}) {
    const double found = distance(whole, sides, tolerance);
    CHECK(found <= 1 + 1e-9);
    CHECK(found >= 1 / (1 + tolerance) - 1e-9);
    CHECK(distance(sides, whole, tolerance) == doctest::Approx(found).epsilon(tolerance));
  }
}

TEST_CASE("Surfaces that are the same have no distance, and one that is shifted has the shift") {
  MadeSurface box, shifted;
  box.add_box({0, 0, 0}, {3, 2, 1});
  shifted.add_box({0, 0, 0.125}, {3, 2, 1});
  CHECK(distance(box, box, 0.005) < 1e-11);
  CHECK(distance(box, shifted, 0.005) == 0.125);
}

TEST_CASE("Figures of a box are those of its corners, at any size") {
  MadeSurface surface;
  surface.add_box({0, 0, 0}, {1, 1, 1});
  Box box({1, 1, 1.25});
  for (const double size : {1.0, 1e300, 1e-300, 1e-30}) {
    MadeSurface s = surface;
    Box b = box;
    for (Vector3& p : s.positions)
      p *= size;
    for (Vector3& p : b.positions)
      p *= size;
    const HexFigures figures = figures_of(b.positions, b.hexahedra, s.positions, s.triangles, base::Host());
    CHECK(figures.volume_error == doctest::Approx(25).epsilon(1e-12));
    CHECK(figures.distance == doctest::Approx(25 / std::sqrt(3)).epsilon(1e-12));
  }
  CHECK(figures_of(box.positions, box.hexahedra, surface.positions, surface.triangles, base::Host()).volume ==
        doctest::Approx(1.25).epsilon(1e-14));
}

TEST_CASE("Straight rods and plates are filled in a space where they are thick, other shapes in their own") {
  const auto space_of = [](const MadeSurface& s) {
    return WorkingSpace(s.positions, s.triangles, size_exponent(s.positions));
  };
  MadeSurface cube, rod, plate;
  cube.add_box({3, 4, 5}, {1, 2, 15});
  CHECK(space_of(cube).same());
  rod.add_rod(12, 2000);
  plate.add_box({7, 0, 0}, {1000, 900, 1});
  for (MadeSurface* s : {&rod, &plate}) {
    s->turn(Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()));
    const WorkingSpace space = space_of(*s);
    REQUIRE_FALSE(space.same());
    CHECK(space.exponent() == 0);
    MadeSurface within = *s;
    space.take(within.positions);
    double largest = 0;
    for (std::size_t v = 0; v < within.positions.size(); ++v) {
      largest = std::max(largest, (space.back(within.positions[v]) - s->positions[v]).norm());
    }
    CHECK(largest < 1e-11);
    const WorkingSpace again = space_of(within);
    CHECK(again.same());
  }
  // A thin ring fills little of its box: stretching would make a ribbon of it. A wide flat one is stretched.
  CHECK(space_of(ring(0.01, 1)).same());
  CHECK_FALSE(space_of(ring(0.15, 0.01)).same());
}

TEST_CASE("Coordinates far from 1 are divided by a power of two") {
  MadeSurface box;
  box.add_box({0, 0, 0}, {1, 2, 3});
  for (const int exponent : {900, -900}) {
    MadeSurface s = box;
    for (Vector3& p : s.positions)
      p = times_power_of_two(p, exponent);
    const WorkingSpace space(s.positions, s.triangles, size_exponent(s.positions));
    CHECK(std::abs(space.exponent() - exponent) <= 2);
    for (const Vector3& p : s.positions) {
      const Vector3 there = space.to(p);
      CHECK(there.cwiseAbs().maxCoeff() <= 1);
      CHECK(times_power_of_two(space.back(there), space.exponent()) == p);
    }
  }
}

TEST_CASE("More pieces than cells are refused") {
  CHECK_NOTHROW(require_cells_for_pieces(10, 10));
  CHECK_THROWS_AS(require_cells_for_pieces(11, 10), base::Error);
}

TEST_CASE("A speck beside a ball has figures of its own, and does not count as much as the ball") {
  MadeSurface balls;
  const base::Host host;
  // Two octahedra, one a hundredth as large.
  const auto add = [&](const Vector3& center, double radius) {
    const auto first = static_cast<Index>(balls.positions.size());
    for (int axis = 0; axis < 3; ++axis) {
      for (const double side : {1.0, -1.0})
        balls.positions.push_back(center + side * radius * Vector3::Unit(axis));
    }
    constexpr Triangle faces[] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                  {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (Triangle t : faces) {
      for (Index& v : t)
        v += first;
      balls.triangles.push_back(t);
    }
    return first;
  };
  add({0, 0, 0}, 1);
  add({2, 0, 0}, 0.01);
  std::vector<polycube::SurfaceMap> none;
  std::vector<std::vector<Triangle>> parts(2);
  for (std::size_t i = 0; i < balls.triangles.size(); ++i)
    parts[i / 8].push_back(balls.triangles[i]);
  const polycube::SurfaceMap empty(host.memory);
  std::vector<PolycubeSurface> pieces;
  for (const auto& part : parts)
    pieces.push_back({empty, balls.positions, part});
  const HexResult made =
      make_hexahedra_of_pieces(pieces, {.method = HexMethod::grid, .cells = 300, .distance = 20}, host);
  REQUIRE(made.pieces.size() == 2);
  CHECK(made.quality.valid());
  CHECK(made.pieces[0].hexahedra + made.pieces[1].hexahedra == made.mesh.hexahedra.size());
  CHECK((made.pieces[1].place - Vector3(2, 0, 0)).norm() < 1e-12);
  // The volume of the whole is off by what both are, of which the speck is a millionth.
  CHECK(made.volume_error == doctest::Approx(made.pieces[0].volume_error).epsilon(1e-3));
  const double whole = Vector3(3.01, 2, 2).norm(), first = Vector3(2, 2, 2).norm();
  CHECK(made.distance >= 0.995 * made.pieces[0].distance * first / whole);
  CHECK(made.distance <=
        1.005 * std::max(made.pieces[0].distance * first, made.pieces[1].distance * 0.02 * std::sqrt(3)) / whole);
}
