// Normals and areas of vertices, and the mean distance of point sets.
#include "mesh/search/vertex_measures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "base/error.h"
#include "mesh/search/distances.h"
#include "mesh/shapes/make_shape.h"

using namespace orbicube;
using namespace orbicube::mesh;

TEST_CASE("The areas of the vertices are thirds of their triangles") {
  const base::Host host;
  const std::vector<Vector3> positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}, {9, 9, 9}};
  const std::vector<Triangle> triangles = {{0, 2, 1}, {0, 1, 3}};
  const auto areas = vertex_areas(positions, triangles, host);
  const double expected[] = {(3 + 4) / 3.0, (3 + 4) / 3.0, 1, 4 / 3.0, 0};
  for (std::size_t v = 0; v < 5; ++v)
    CHECK(areas[v] == doctest::Approx(expected[v]).epsilon(1e-15));
  CHECK_THROWS_AS(vertex_areas(positions, std::vector<Triangle>{{0, 1, 5}}, host), base::Error);
}

TEST_CASE("The mean distance is that of a search through all points") {
  std::mt19937_64 engine(41);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  for (const std::size_t count : {1UL, 7UL, 300UL, 3000UL}) {
    std::vector<Vector3> a(count), b(count / 2 + 1);
    for (Vector3& p : a)
      p = Vector3(normal(engine), normal(engine), 0.01 * normal(engine));
    for (Vector3& p : b)
      p = uniform(engine) < 0.2 ? a[0] : Vector3(normal(engine), 2 * normal(engine), 0);
    const auto one_way = [](const std::vector<Vector3>& from, const std::vector<Vector3>& to) {
      double sum = 0;
      for (const Vector3& p : from) {
        double least = std::numeric_limits<double>::infinity();
        for (const Vector3& q : to)
          least = std::min(least, (p - q).norm());
        sum += least;
      }
      return sum / static_cast<double>(from.size());
    };
    base::Host one, three;
    one.thread_count = 1;
    three.thread_count = 3;
    const double found = mean_distance(a, b, one);
    CHECK(found == doctest::Approx(std::max(one_way(a, b), one_way(b, a))).epsilon(1e-13));
    CHECK(mean_distance(a, b, three) == found);
    CHECK(mean_distance(b, a, three) == found);
    CHECK(mean_distance(a, a, one) == 0);
  }
}

TEST_CASE("Sets without points, or with points that are not finite, are refused") {
  const base::Host host;
  const std::vector<Vector3> some = {{1, 2, 3}}, none, bad = {{1, 2, 3}, {std::nan(""), 0, 0}};
  CHECK_THROWS_AS(mean_distance(some, none, host), base::Error);
  CHECK_THROWS_AS(mean_distance(none, some, host), base::Error);
  CHECK_THROWS_WITH_AS(mean_distance(some, bad, host), "point 1 is not finite", base::Error);
  const std::vector<Vector3> far = {{0, 1e160, 0}};
  CHECK_THROWS_WITH_AS(mean_distance(far, some, host), "point 0 has a coordinate beyond 1e150", base::Error);
}

TEST_CASE("Normals of a sphere are its directions, at any size, and zero triangles have none") {
  Mesh sphere = make_shape("sphere", {.triangles = 5000}, base::Host());
  for (Vector3& p : sphere.positions)
    p.normalize();
  for (const double size : {1.0, 1e200, 1e-200}) {
    std::vector<Vector3> positions;
    for (const Vector3& p : sphere.positions)
      positions.push_back(size * p);
    const auto normals = vertex_normals(positions, sphere.triangles, base::Host());
    for (std::size_t v = 0; v < positions.size(); ++v) {
      CHECK(normals[v].norm() == doctest::Approx(1).epsilon(1e-14));
      // Edges are 0.1 long, and where they are not symmetric round a vertex a normal is off by a part of that.
      CHECK((normals[v] - sphere.positions[v]).norm() < 0.02);
    }
  }
  const std::vector<Vector3> point(3, Vector3(1, 2, 3));
  const std::vector<Triangle> flat{{0, 1, 2}};
  CHECK(vertex_normals(point, flat, base::Host())[1] == Vector3::UnitZ());
}

TEST_CASE("Normals do not depend on how a face is cut") {
  // A cube's corner between three faces, one of them cut into two triangles at the corner and then not.
  const std::vector<Vector3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  const std::vector<Triangle> whole{{0, 2, 1}, {0, 3, 2}, {0, 1, 3}};
  const std::vector<Triangle> cut{{0, 2, 4}, {0, 4, 1}, {0, 3, 2}, {0, 1, 3}};
  const auto a = vertex_normals(x, whole, base::Host());
  const auto b = vertex_normals(x, cut, base::Host());
  CHECK((a[0] - b[0]).norm() < 1e-15);
  CHECK((a[0] - Vector3(-1, -1, -1).normalized()).norm() < 1e-15);
}
