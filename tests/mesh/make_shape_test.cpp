// Every shape at random resolutions and seeds: closed, manifold, outward, of its genus, not meeting itself, and planar
// where it has planes.
#include "mesh/shapes/make_shape.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/topology.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

// Whether the open segment p q passes through the triangle, its sides included, without lying in its plane.
bool pierces(const Vector3& p, const Vector3& q, const std::array<Vector3, 3>& t) {
  const int side = orientation_3d(t[0], t[1], t[2], p);
  if (side == 0 || orientation_3d(t[0], t[1], t[2], q) != -side) return false;
  int positive = 0;
  int negative = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const int turn = orientation_3d(p, q, t[k], t[(k + 1) % 3]);
    positive += turn > 0;
    negative += turn < 0;
  }
  return positive == 0 || negative == 0;
}

// Pairs of triangles without a common vertex that meet; each with each, behind a test of boxes.
std::size_t intersections(const Mesh& mesh) {
  struct Item {
    Eigen::AlignedBox3d box;
    Index triangle;
  };
  std::vector<Item> items;
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    Eigen::AlignedBox3d box;
    for (const Index v : mesh.triangles[t])
      box.extend(mesh.positions[v]);
    items.push_back({box, t});
  }
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) { return a.box.min()[0] < b.box.min()[0]; });
  std::size_t found = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    for (std::size_t j = i + 1; j < items.size() && items[j].box.min()[0] <= items[i].box.max()[0]; ++j) {
      if (!items[i].box.intersects(items[j].box)) continue;
      const Triangle& a = mesh.triangles[items[i].triangle];
      const Triangle& b = mesh.triangles[items[j].triangle];
      if (std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end()) continue;
      const auto corners = [&](const Triangle& t) {
        return std::array<Vector3, 3>{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
      };
      const auto first = corners(a);
      const auto second = corners(b);
      bool meet = false;
      for (std::size_t k = 0; k < 3; ++k) {
        meet = meet || pierces(first[k], first[(k + 1) % 3], second) || pierces(second[k], second[(k + 1) % 3], first);
      }
      found += meet;
    }
  }
  return found;
}

Mesh make(std::string_view name, std::size_t triangles, std::uint64_t seed) {
  return make_shape(name, {.triangles = triangles, .seed = seed}, base::Host());
}

}  // namespace

TEST_CASE("shapes of random resolution and seed are closed, outward, of their genus, and do not meet themselves") {
  std::mt19937_64 random(7);
  for (const ShapeDescription& shape : shapes()) {
    for (int attempt = 0; attempt < 12; ++attempt) {
      const std::size_t wanted = 800 + random() % 2500;
      const std::uint64_t seed = random();
      CAPTURE(shape.name);
      CAPTURE(wanted);
      CAPTURE(seed);
      const Mesh mesh = make(shape.name, wanted, seed);
      const Topology facts = topology(mesh.positions, mesh.triangles, base::Host());
      CHECK(facts.closed());
      CHECK(facts.manifold());
      CHECK(facts.components == 1);
      CHECK(facts.inconsistent_edges == 0);
      CHECK(facts.unreferenced_vertices == 0);
      CHECK(facts.zero_area_faces == 0);
      CHECK(facts.genus == shape.genus);
      CHECK(facts.volume > 0);
      CHECK(intersections(mesh) == 0);
      // Strips come in whole numbers: with few patches the count jumps.
      CHECK(static_cast<double>(mesh.triangles.size()) > 0.75 * static_cast<double>(wanted));
      CHECK(static_cast<double>(mesh.triangles.size()) < 1.3 * static_cast<double>(wanted));
    }
  }
}

TEST_CASE("the test of intersections finds what there is") {
  Mesh mesh;
  mesh.positions.assign({{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0.5, 0.5, -1}, {0.5, 0.5, 1}, {5, 5, 1}});
  mesh.triangles.assign({{0, 1, 2}, {3, 4, 5}});
  CHECK(intersections(mesh) == 1);
  mesh.positions[4] = {0.5, 0.5, -0.5};
  mesh.positions[5] = {5, 5, -0.5};
  CHECK(intersections(mesh) == 0);
}

TEST_CASE("the same options give the same bits, another seed another shape") {
  for (const ShapeDescription& shape : shapes()) {
    CAPTURE(shape.name);
    const Mesh first = make(shape.name, 2000, 5);
    CHECK(first.positions == make(shape.name, 2000, 5).positions);
    CHECK(first.triangles == make(shape.name, 2000, 5).triangles);
    const std::string name = shape.name;
    const bool varied = name != "cube" && name != "sphere";
    CHECK((first.positions != make(name, 2000, 6).positions) == varied);
  }
}

TEST_CASE("a seed gives the same shape whatever the compiler") {
  struct Known {
    const char* shape;
    std::uint64_t seed;
    std::size_t vertices;
    Vector3 last;  // position of the last vertex, to six digits
  };
  const std::vector<Known> known = {
      {"creature", 1, 1002, {0.880218, 0.737727, -0.229098}},   {"blob", 1, 1016, {1.1979, 0.938491, 0.938491}},
      {"star", 1, 1016, {0.407522, 0.319273, 0.319273}},        {"torus", 1, 1088, {1.18769, -0.110056, -0.0798521}},
      {"bracket", 1, 990, {0.622542, 0.924398, 0.0823632}},     {"three-holes", 1, 1012, {2.31255, 1.02098, 0.235781}},
      {"creature", 2, 1084, {2.01251, 0.815778, -3.02473e-06}}, {"blob", 2, 1016, {0.602746, 0.472221, 0.472221}},
      {"star", 2, 1016, {0.402008, 0.314953, 0.314953}},        {"torus", 2, 960, {1.43911, -0.227932, -0.122465}},
      {"bracket", 2, 990, {0.910204, 1.34356, 0.124698}},       {"three-holes", 2, 998, {2.93392, 0.828165, 0.461634}},
  };
  for (const Known& k : known) {
    CAPTURE(k.shape);
    CAPTURE(k.seed);
    const Mesh mesh = make(k.shape, 2000, k.seed);
    REQUIRE(mesh.positions.size() == k.vertices);
    CHECK((mesh.positions.back() - k.last).norm() < 1e-5);
  }
}

TEST_CASE("faces of cube and plate lie exactly in planes along the axes") {
  for (const char* name : {"cube", "three-holes"}) {
    const Mesh mesh = make(name, 3000, 11);
    std::size_t tilted = 0;
    for (const Triangle& t : mesh.triangles) {
      bool planar = false;
      for (int axis = 0; axis < 3; ++axis) {
        planar = planar || (mesh.positions[t[0]][axis] == mesh.positions[t[1]][axis] &&
                            mesh.positions[t[1]][axis] == mesh.positions[t[2]][axis]);
      }
      tilted += !planar;
    }
    CHECK(tilted == 0);
  }
}

TEST_CASE("the underside of the bracket is exactly flat") {
  const Mesh mesh = make("bracket", 4000, 9);
  std::size_t under = 0;
  for (const Triangle& t : mesh.triangles) {
    const auto height = [&](std::size_t k) { return mesh.positions[t[k]][2]; };
    // The walls of the holes have triangles that leave the plane, far beyond roundoff.
    if (std::max({height(0), height(1), height(2)}) > 1e-3) continue;
    ++under;
    CHECK(std::max({height(0), height(1), height(2)}) == 0);
    CHECK(std::min({height(0), height(1), height(2)}) == 0);
  }
  CHECK(under > 100);
}

TEST_CASE("sphere and torus are on their surfaces, the cube has its volume") {
  for (const Vector3& p : make("sphere", 5000, 3).positions)
    CHECK(std::abs(p.norm() - 1) < 4e-16);  // two roundings of a normalized vector
  for (const Vector3& p : make("torus", 5000, 0).positions) {
    const double from_circle = std::hypot(std::hypot(p[0], p[1]) - 1, p[2]);
    CHECK(std::abs(from_circle - 0.35) < 1e-15);
  }
  const Mesh cube = make("cube", 5000, 0);
  CHECK(topology(cube.positions, cube.triangles, base::Host()).volume == doctest::Approx(8).epsilon(1e-13));
}

TEST_CASE("a million triangles come within a hundredth of what was requested") {
  const Mesh mesh = make("creature", 1'000'000, 1);
  CHECK(std::abs(static_cast<double>(mesh.triangles.size()) - 1e6) < 1e4);
}

TEST_CASE("unknown shapes and absurd sizes are refused") {
  CHECK_THROWS_AS(make("teapot", 100, 0), base::Error);
  CHECK_THROWS_AS(make("cube", 200'000'000, 0), base::Error);
}
