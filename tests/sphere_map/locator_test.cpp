// The inverse map: exactness, the rule for borders, uneven maps, the same results on threads.
#include "sphere_map/sampling/locator.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "shapes.h"
#include "uneven_maps.h"

using namespace orbicube;
using sphere_map::Location;
using sphere_map::Locator;

namespace {

using test::MappedShape;

// The triangles that the direction is in or on the border of, by looking at each, exactly.
std::vector<mesh::Index> triangles_with(const mesh::Vector3& d, std::span<const mesh::Triangle> triangles,
                                        std::span<const mesh::Vector3> directions) {
  std::vector<mesh::Index> found;
  for (mesh::Index t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    const auto side = [&](mesh::Index from, mesh::Index to) {
      return mesh::orientation_from_origin(directions[from], directions[to], d);
    };
    if (side(a, b) >= 0 && side(b, c) >= 0 && side(c, a) >= 0) found.push_back(t);
  }
  return found;
}

void check_weights(const Location& at) {
  CHECK(at.weights.minCoeff() >= 0);
  CHECK(at.weights.sum() == doctest::Approx(1).epsilon(1e-14));
}

// Queries that are spread evenly, at and near vertices, on edges and in triangles.
std::vector<mesh::Vector3> queries_on(std::span<const mesh::Triangle> triangles,
                                      std::span<const mesh::Vector3> directions, std::size_t count) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<mesh::Vector3> queries;
  for (std::size_t i = 0; i < count; ++i) {
    const mesh::Triangle& t = triangles[random() % triangles.size()];
    const mesh::Vector3 &p = directions[t[0]], &q = directions[t[1]], &r = directions[t[2]];
    const double a = unit(random);
    const double b = unit(random) * (1 - a);
    queries.push_back(test::random_direction(random));
    queries.push_back((a * p + b * q + (1 - a - b) * r).normalized());
    queries.push_back(p);
    queries.push_back((a * p + (1 - a) * q).normalized());
    queries.push_back(mesh::Vector3(std::nextafter(p.x(), 2), p.y(), p.z()));
  }
  return queries;
}

void check_all(std::span<const mesh::Triangle> triangles, std::span<const mesh::Vector3> directions,
               std::size_t count) {
  REQUIRE(sphere_map::count_not_positive(triangles, directions) == 0);
  const Locator locator(triangles, directions, base::Host());
  std::size_t wrong = 0;
  std::size_t without_triangle = 0;
  for (const mesh::Vector3& d : queries_on(triangles, directions, count)) {
    const Location at = locator.locate(d);
    const auto with = triangles_with(d, triangles, directions);
    without_triangle += with.empty();
    wrong += with.empty() || at.triangle != with.front();
    check_weights(at);
  }
  CHECK(without_triangle == 0);
  CHECK(wrong == 0);
}

}  // namespace

TEST_CASE("Each direction is found in the lowest of the triangles that have it, exactly") {
  const MappedShape shape = test::mapped("creature", 3000);
  check_all(shape.surface.triangles, shape.directions, 150);
  const test::Surface octahedron = test::sphere(0);
  check_all(octahedron.triangles, octahedron.positions, 50);
  const test::Surface tetrahedron = test::tetrahedron();
  std::vector<mesh::Vector3> unit;
  for (const mesh::Vector3& p : tetrahedron.positions)
    unit.push_back(p.normalized());
  check_all(tetrahedron.triangles, unit, 50);
}

TEST_CASE("Maps whose areas differ by fifteen orders of magnitude and more are inverted exactly") {
  for (const char* name : {"star", "creature"}) {
    const MappedShape shape = test::mapped(name, 2500);
    std::vector<mesh::Triangle> triangles(shape.surface.triangles.begin(), shape.surface.triangles.end());
    std::vector<mesh::Vector3> directions(shape.directions.begin(), shape.directions.end());
    for (const std::size_t t : {7U, 77U, 777U})
      test::nest(triangles, directions, t, 0.05, 40);
    double least = 1, largest = 0;
    for (const auto& [a, b, c] : triangles) {
      const double area = sphere_map::solid_angle(directions[a], directions[b], directions[c]);
      least = std::min(least, area);
      largest = std::max(largest, area);
    }
    CHECK(largest / least > 1e15);
    check_all(triangles, directions, 60);
    // In each of the smallest triangles too, of which few come by chance.
    const Locator locator(triangles, directions, base::Host());
    for (std::size_t t = shape.surface.triangles.size(); t < triangles.size(); ++t) {
      const auto& [a, b, c] = triangles[t];
      const mesh::Vector3 middle = directions[a] + directions[b] + directions[c];
      CHECK(locator.locate(middle).triangle == triangles_with(middle, triangles, directions).front());
    }
  }
}

TEST_CASE("A vertex of very many triangles, in the middle of thin ones, is found from everywhere") {
  // Two poles joined by a ring of 4000 vertices.
  constexpr mesh::Index around = 4000;
  std::vector<mesh::Vector3> directions;
  std::vector<mesh::Triangle> triangles;
  for (mesh::Index i = 0; i < around; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / around;
    directions.push_back({std::cos(angle), std::sin(angle), 0});
    triangles.push_back({i, (i + 1) % around, around});
    triangles.push_back({(i + 1) % around, i, around + 1});
  }
  directions.push_back({0, 0, 1});
  directions.push_back({0, 0, -1});
  check_all(triangles, directions, 40);
  const Locator locator(triangles, directions, base::Host());
  for (int i = 1; i < 300; ++i) {
    const mesh::Vector3 d(std::cos(i) * std::pow(0.9, i), std::sin(i) * std::pow(0.9, i), 1);
    CHECK(locator.locate(d).triangle == triangles_with(d, triangles, directions).front());
  }
}

TEST_CASE("The directions of the vertices give the vertices back, and the middles of edges those") {
  const MappedShape shape = test::mapped("blob", 2000);
  const auto& triangles = shape.surface.triangles;
  const Locator locator(triangles, shape.directions, base::Host());
  for (mesh::Index v = 0; v < shape.directions.size(); ++v) {
    for (const double length : {1.0, 0x1p-1000, 0x1p40}) {
      const Location at = locator.locate(length * shape.directions[v]);
      const mesh::Triangle& t = triangles[at.triangle];
      for (Eigen::Index k = 0; k < 3; ++k)
        CHECK(at.weights[k] == (t[static_cast<std::size_t>(k)] == v ? 1.0 : 0.0));
    }
  }
  // On a plane of coordinates, middles of edges are exact.
  const test::Surface octahedron = test::sphere(0);
  const Locator on_octahedron(octahedron.triangles, octahedron.positions, base::Host());
  const Location middle = on_octahedron.locate({1, 1, 0});
  CHECK(middle.triangle == 0);
  CHECK(middle.weights == mesh::Vector3(0.5, 0.5, 0));
}

TEST_CASE("Weights say where the ray meets the flat triangle") {
  const MappedShape shape = test::mapped("creature", 3000);
  const Locator locator(shape.surface.triangles, shape.directions, base::Host());
  std::mt19937_64 random(9);
  for (int i = 0; i < 2000; ++i) {
    const mesh::Vector3 d = test::random_direction(random);
    const Location at = locator.locate(d);
    const mesh::Triangle& t = shape.surface.triangles[at.triangle];
    mesh::Vector3 point = mesh::Vector3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      point += at.weights[static_cast<Eigen::Index>(k)] * shape.directions[t[k]];
    // A few roundings of numbers near 1.
    CHECK((point.normalized() - d).norm() < 2e-15);
  }
}

TEST_CASE("A mirrored map is inverted as well") {
  MappedShape shape = test::mapped("blob", 1500);
  const Locator plain(shape.surface.triangles, shape.directions, base::Host());
  std::vector<mesh::Triangle> turned(shape.surface.triangles.begin(), shape.surface.triangles.end());
  for (mesh::Triangle& t : turned)
    std::swap(t[1], t[2]);
  const Locator mirrored(turned, shape.directions, base::Host());
  std::mt19937_64 random(3);
  for (int i = 0; i < 500; ++i) {
    const mesh::Vector3 d = test::random_direction(random);
    const Location a = plain.locate(d);
    const Location b = mirrored.locate(d);
    CHECK(a.triangle == b.triangle);
    CHECK((a.weights - mesh::Vector3(b.weights[0], b.weights[2], b.weights[1])).norm() < 1e-9);
  }
}

TEST_CASE("What is no bijection is refused") {
  const test::Surface good = test::sphere(2);
  const auto kind_of = [](const std::vector<mesh::Triangle>& triangles, const std::vector<mesh::Vector3>& directions) {
    try {
      const Locator locator(triangles, directions, base::Host());
    } catch (const base::Error& e) {
      return std::string(e.kind());
    }
    return std::string();
  };
  CHECK(kind_of(good.triangles, good.positions) == "");
  CHECK(kind_of({}, good.positions) == "invalid-argument");
  auto flipped = good.positions;
  flipped[7] = -flipped[7];
  CHECK(kind_of(good.triangles, flipped) == "invalid-argument");
  auto flat = good.positions;
  flat[good.triangles[5][0]] = flat[good.triangles[5][1]];
  CHECK(kind_of(good.triangles, flat) == "invalid-argument");
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e9}) {
    auto wrong = good.positions;
    wrong[3].y() = bad;
    CHECK(kind_of(good.triangles, wrong) == "invalid-argument");
  }
  auto open = good.triangles;
  open.pop_back();
  CHECK(kind_of(open, good.positions) == "not-closed");
  auto out_of_range = good.triangles;
  out_of_range[2][1] = static_cast<mesh::Index>(good.positions.size());
  CHECK(kind_of(out_of_range, good.positions) == "invalid-argument");
  // Two spheres: each direction would be in two triangles.
  auto twice = good;
  const auto offset = static_cast<mesh::Index>(good.positions.size());
  for (const mesh::Triangle& t : good.triangles)
    twice.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  twice.positions.insert(twice.positions.end(), good.positions.begin(), good.positions.end());
  CHECK(kind_of(twice.triangles, twice.positions) == "invalid-argument");
}

TEST_CASE("Batches have the same bits on any number of threads, and refuse what is no direction") {
  const MappedShape shape = test::mapped("star", 4000);
  std::mt19937_64 random(1);
  std::vector<mesh::Vector3> queries;
  for (int i = 0; i < 40'000; ++i)
    queries.push_back(test::random_direction(random));
  std::vector<Location> first;
  for (const unsigned threads : {1U, 2U, 5U}) {
    base::Host host;
    host.thread_count = threads;
    const Locator locator(shape.surface.triangles, shape.directions, host);
    std::vector<Location> locations(queries.size());
    locator.for_each_location(queries, host, [&](std::size_t i, const Location& at) { locations[i] = at; });
    if (first.empty()) first = locations;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      REQUIRE(locations[i].triangle == first[i].triangle);
      REQUIRE(std::memcmp(locations[i].weights.data(), first[i].weights.data(), 3 * sizeof(double)) == 0);
    }
  }
  const Locator locator(shape.surface.triangles, shape.directions, base::Host());
  for (const mesh::Vector3& bad : {mesh::Vector3(0, 0, 0), mesh::Vector3(NAN, 0, 1), mesh::Vector3(0, INFINITY, 1)}) {
    CHECK_THROWS_AS(locator.for_each_location({&bad, 1}, base::Host(), [](std::size_t, const Location&) {}),
                    base::Error);
  }
}
