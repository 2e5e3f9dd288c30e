// Values sampled through the inverse of a map.
#include "sphere_map/sampling/sampling.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "base/error.h"
#include "shapes.h"
#include "uneven_maps.h"

using namespace orbicube;
using sphere_map::Interpolation;

TEST_CASE("Sampling at the vertices gives the vertices' own values to the bit") {
  const test::MappedShape shape = test::mapped("creature", 2000);
  const sphere_map::Locator locator(shape.surface.triangles, shape.directions, base::Host());
  const auto sampled = sphere_map::sample_vectors(locator, shape.directions, shape.surface.positions,
                                                  Interpolation::linear, base::Host());
  CHECK(std::equal(sampled.begin(), sampled.end(), shape.surface.positions.begin()));
}

TEST_CASE("What is linear in the flat triangles is sampled exactly") {
  const test::MappedShape shape = test::mapped("blob", 2000);
  const sphere_map::Locator locator(shape.surface.triangles, shape.directions, base::Host());
  std::mt19937_64 random(2);
  std::vector<mesh::Vector3> queries;
  for (int i = 0; i < 500; ++i)
    queries.push_back(test::random_direction(random));
  // The directions themselves: the sample is on the ray.
  const auto sampled =
      sphere_map::sample_vectors(locator, queries, shape.directions, Interpolation::linear, base::Host());
  const auto unit = sphere_map::sample_vectors(locator, queries, shape.directions, Interpolation::unit, base::Host());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    CHECK(sampled[i].cross(queries[i]).norm() < 2e-15);
    CHECK(sampled[i].norm() <= 1 + 1e-15);
    CHECK((unit[i] - queries[i]).norm() < 2e-15);
  }
  // A constant and one of another component count.
  const std::vector<double> constant(5 * shape.directions.size(), 3.25);
  std::vector<double> five(5 * queries.size());
  sphere_map::sample(locator, queries, constant, 5, Interpolation::linear, five, base::Host());
  for (const double x : five)
    CHECK(x == doctest::Approx(3.25).epsilon(1e-15));
}

TEST_CASE("Sizes that do not fit are refused") {
  const test::Surface octahedron = test::sphere(0);
  const sphere_map::Locator locator(octahedron.triangles, octahedron.positions, base::Host());
  const std::vector<mesh::Vector3> queries(2, mesh::Vector3(1, 2, 3));
  std::vector<double> values(12), sampled(4);
  CHECK_NOTHROW(sphere_map::sample(locator, queries, values, 2, Interpolation::linear, sampled, base::Host()));
  CHECK_THROWS_AS(sphere_map::sample(locator, queries, values, 0, Interpolation::linear, sampled, base::Host()),
                  base::Error);
  CHECK_THROWS_AS(sphere_map::sample(locator, queries, values, 1, Interpolation::linear, sampled, base::Host()),
                  base::Error);
  sampled.pop_back();
  CHECK_THROWS_AS(sphere_map::sample(locator, queries, values, 2, Interpolation::linear, sampled, base::Host()),
                  base::Error);
}

TEST_CASE("Normals of a sphere are its directions, at any size, and zero triangles have none") {
  const test::Surface sphere = test::sphere(4);
  for (const double size : {1.0, 1e200, 1e-200}) {
    std::vector<mesh::Vector3> positions;
    for (const mesh::Vector3& p : sphere.positions)
      positions.push_back(size * p);
    const auto normals = sphere_map::vertex_normals(positions, sphere.triangles, base::Host());
    for (std::size_t v = 0; v < positions.size(); ++v) {
      CHECK(normals[v].norm() == doctest::Approx(1).epsilon(1e-14));
      // Edges are 0.1 long, and where they are not symmetric round a vertex a normal is off by a part of that.
      CHECK((normals[v] - sphere.positions[v]).norm() < 0.02);
    }
  }
  const std::vector<mesh::Vector3> point(3, mesh::Vector3(1, 2, 3));
  const std::vector<mesh::Triangle> flat{{0, 1, 2}};
  CHECK(sphere_map::vertex_normals(point, flat, base::Host())[1] == mesh::Vector3::UnitZ());
}

TEST_CASE("Normals do not depend on how a face is cut") {
  // A cube's corner between three faces, one of them cut into two triangles at the corner and then not.
  const std::vector<mesh::Vector3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  const std::vector<mesh::Triangle> whole{{0, 2, 1}, {0, 3, 2}, {0, 1, 3}};
  const std::vector<mesh::Triangle> cut{{0, 2, 4}, {0, 4, 1}, {0, 3, 2}, {0, 1, 3}};
  const auto a = sphere_map::vertex_normals(x, whole, base::Host());
  const auto b = sphere_map::vertex_normals(x, cut, base::Host());
  CHECK((a[0] - b[0]).norm() < 1e-15);
  CHECK((a[0] - mesh::Vector3(-1, -1, -1).normalized()).norm() < 1e-15);
}
