// How faces of many corners become triangles.
#include "mesh/files/polygons.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "read_text.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

struct Place {
  [[noreturn]] void fail(const char* kind, const std::string& what) const { throw base::Error(kind, what); }
};

Array<Triangle> cut(const std::vector<Vector3>& positions) {
  Polygons polygons(std::pmr::get_default_resource());
  std::vector<Index> face(positions.size());
  for (std::size_t i = 0; i < face.size(); ++i)
    face[i] = static_cast<Index>(i);
  polygons.add(face, Place());
  Array<Triangle> triangles;
  polygons.to_triangles(positions, triangles, base::Host());
  return triangles;
}

// Every triangle positive, all together the polygon's area: with k - 2 of them, that is a triangulation.
void check_triangulation(const std::vector<Vector3>& positions, const Array<Triangle>& triangles) {
  Vector3 whole = Vector3::Zero();
  for (std::size_t i = 0; i < positions.size(); ++i)
    whole += 0.5 * positions[i].cross(positions[(i + 1) % positions.size()]);
  REQUIRE(triangles.size() == positions.size() - 2);
  const Vector3 up = whole.normalized();
  double sum = 0;
  for (const Triangle& t : triangles) {
    const Vector3 &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]];
    const double area = 0.5 * (b - a).cross(c - a).dot(up);
    CHECK(area > -1e-12 * whole.norm());
    sum += area;
  }
  CHECK(sum == doctest::Approx(whole.norm()).epsilon(1e-9));
}

std::vector<Vector3> turned(std::vector<Vector3> flat) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond(0.3, -0.7, 0.2, 0.6).normalized();
  for (Vector3& p : flat)
    p = turn * p + Vector3(1, 2, 3);
  return flat;
}

}  // namespace

TEST_CASE("A convex face is a fan from its first corner") {
  std::vector<Vector3> hexagon;
  for (int i = 0; i < 6; ++i)
    hexagon.emplace_back(std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3), 0.0);
  const auto triangles = cut(hexagon);
  for (Index i = 0; i < 4; ++i)
    CHECK(triangles[i] == Triangle{0, i + 1, i + 2});
}

TEST_CASE("Concave faces, wherever they start and however they lie, are cut without flipping a triangle") {
  std::mt19937_64 engine(11);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11U) * 0x1p-53; };
  for (const int size : {4, 5, 7, 10, 33, 200}) {
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<Vector3> star;  // seen from the middle, so that it does not cross itself
      for (int i = 0; i < size; ++i) {
        const double angle = 2 * std::numbers::pi * i / size;
        star.emplace_back((0.05 + uniform()) * Vector3(std::cos(angle), std::sin(angle), 0.0));
      }
      check_triangulation(star, cut(star));
      check_triangulation(turned(star), cut(turned(star)));
    }
  }
}

TEST_CASE("A comb with thousands of teeth and a spiral are cut") {
  std::vector<Vector3> comb = {{0, -1, 0}, {2001, -1, 0}};
  for (int i = 2000; i > 0; --i)
    comb.emplace_back(i, i % 2 == 0 ? 1.0 : 0.0, 0.0);
  check_triangulation(comb, cut(comb));
  std::vector<Vector3> spiral;
  for (int i = 0; i < 600; ++i)
    spiral.emplace_back((1.0 + 0.01 * i) * Vector3(std::cos(0.1 * i), std::sin(0.1 * i), 0.0));
  for (int i = 599; i >= 0; --i)
    spiral.emplace_back((1.2 + 0.01 * i) * Vector3(std::cos(0.1 * i), std::sin(0.1 * i), 0.0));
  std::reverse(spiral.begin(), spiral.end());
  check_triangulation(spiral, cut(spiral));
}

TEST_CASE("Corners on a straight edge make no flat triangle of a square") {
  const std::vector<Vector3> square = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
                                       {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
  for (std::size_t start = 0; start < square.size(); ++start) {
    std::vector<Vector3> shifted = square;
    std::rotate(shifted.begin(), shifted.begin() + static_cast<std::ptrdiff_t>(start), shifted.end());
    const auto triangles = cut(shifted);
    check_triangulation(shifted, triangles);
    for (const Triangle& t : triangles)
      CHECK((shifted[t[1]] - shifted[t[0]]).cross(shifted[t[2]] - shifted[t[0]]).z() > 0);
  }
}

TEST_CASE("Faces that cross themselves, lie on a line or in a point still end as triangles") {
  CHECK(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size() == 2);
  CHECK(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}}).size() == 3);
  CHECK(cut({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).size() == 2);
  CHECK(cut({{1e300, 0, 0}, {0, 1e300, 0}, {-1e300, 0, 0}, {0, -1e300, 0}}).size() == 2);
  std::mt19937_64 engine(5);
  std::vector<Vector3> wild;
  for (int i = 0; i < 300; ++i)
    wild.emplace_back(static_cast<double>(engine() % 20), static_cast<double>(engine() % 20),
                      static_cast<double>(engine() % 3));
  CHECK(cut(wild).size() == 298);
}

TEST_CASE("The number of larger faces is reported") {
  ReadReport report;
  const Mesh mesh = read_text(
      Format::obj, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3 4\nf 1 2 5\nf 1 2 3 4 5\n", {}, &report);
  CHECK(report.polygons == 2);
  CHECK(mesh.triangles.size() == 2 + 1 + 3);
}
