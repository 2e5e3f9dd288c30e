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
