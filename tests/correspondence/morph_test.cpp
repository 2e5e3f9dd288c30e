// Shapes on one triangulation: the same bits for any number of threads, exact ends of blends, and itself for itself.
#include "correspondence/morph.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/error.h"
#include "correspondence/polycube_mesh.h"
#include "mesh/search/measures.h"
#include "mesh/search/nearest.h"
#include "mesh/search/predicates.h"
#include "mesh/shapes/make_shape.h"

using namespace orbicube;
using namespace orbicube::correspondence;
using mesh::Vector3;

namespace {

mesh::Mesh creature(std::uint64_t seed) {
  return mesh::make_shape("creature", {.triangles = 400, .seed = seed}, base::Host());
}

Morph morph_of(const std::vector<mesh::Mesh>& meshes, const MorphOptions& options, unsigned threads = 1) {
  std::vector<SurfaceSpan> shapes;
  for (const mesh::Mesh& m : meshes)
    shapes.push_back({m.positions, m.triangles});
  base::Host host;
  host.thread_count = threads;
  return morph(shapes, options, host);
}

double squared_distance_to(const Vector3& p, const mesh::Mesh& m) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector3& q : m.positions)
    nearest = std::min(nearest, (p - q).squaredNorm());
  return nearest;
}

}  // namespace

TEST_CASE("The same bits come from one and from four threads, through spheres and through a polycube" *
          doctest::test_suite("long")) {
  const std::vector<mesh::Mesh> meshes{creature(0), creature(1)};
  for (const Via via : {Via::sphere, Via::polycube}) {
    const MorphOptions options{.via = via, .pose = Pose::scaled, .cells = 500};
    const Morph one = morph_of(meshes, options), four = morph_of(meshes, options, 4);
    CHECK(one.triangles == four.triangles);
    REQUIRE(one.states.size() == 2);
    CHECK(one.states == four.states);
  }
}

TEST_CASE("Through spheres, a shape corresponds to itself by the identity") {
  const Morph same = morph_of({creature(0), creature(0)}, {.grid = CommonGrid::first});
  double largest = 0;
  for (std::size_t v = 0; v < same.states[0].size(); ++v)
    largest = std::max(largest, (same.states[0][v] - same.states[1][v]).norm());
  CHECK(largest < 1e-9);
}

TEST_CASE("Through spheres, every vertex of each shape is a vertex of the common mesh") {
  const std::vector<mesh::Mesh> meshes{creature(0), creature(1)};
  const Morph both = morph_of(meshes, {.tolerance = 0});
  CHECK(both.states[0].size() >= meshes[0].positions.size());
  mesh::Mesh first, second;
  first.positions = both.states[0];
  second.positions = both.states[1];
  for (const Vector3& p : meshes[0].positions)
    CHECK(squared_distance_to(p, first) == 0);
  for (const Vector3& p : meshes[1].positions)
    CHECK(squared_distance_to(p, second) == 0);
}

TEST_CASE("A blend is a shape at its own weight, and refuses other weights") {
  const Morph both = morph_of({creature(0), creature(1)}, {.grid = CommonGrid::first});
  const base::Host host;
  CHECK(blend(both, std::array{1.0, 0.0}, host) == both.states[0]);
  CHECK(blend(both, std::array{0.0, 1.0}, host) == both.states[1]);
  CHECK(blend(both, std::array{0.5, 0.5}, host)[3] == Vector3(0.5 * both.states[0][3] + 0.5 * both.states[1][3]));
  CHECK_THROWS_AS(blend(both, std::array{1.0}, host), base::Error);
  CHECK_THROWS_AS(blend(both, std::array{1.0, std::nan("")}, host), base::Error);
}

TEST_CASE("Placement takes a turned, moved and scaled copy back onto the first shape") {
  const mesh::Mesh first = creature(0);
  std::vector<base::Array<Vector3>> states{first.positions, first.positions};
  for (Vector3& p : states[1])
    p = 3 * Vector3(-p[1], p[0], p[2]) + Vector3(1, 2, 3);
  place(Pose::scaled, first.triangles, states);
  double largest = 0;
  for (std::size_t v = 0; v < states[0].size(); ++v)
    largest = std::max(largest, (states[0][v] - states[1][v]).norm());
  CHECK(largest < 1e-12);
}

TEST_CASE(
    "Located points lie in the triangles that they name, with weights that are no less than zero and sum to one") {
  const mesh::Mesh a = creature(0), b = creature(1);
  const std::vector<polycube::SurfaceSpan> shapes{{a.positions, a.triangles}, {b.positions, b.triangles}};
  const base::Host host;
  const polycube::CommonPolycube common = polycube::construct_common(shapes, {}, host);
  const PolycubeMesh mesh = triangles_on(common, 500, host);
  for (const polycube::SurfaceMap& map : common.maps) {
    const polycube::LocatedPoints located = polycube::locate(map, mesh.polycube, host);
    for (std::size_t v = 0; v < mesh.polycube.size(); ++v) {
      REQUIRE(located.triangles[v] < map.triangles.size());
      const Vector3& w = located.weights[v];
      const auto& [i, j, k] = map.triangles[located.triangles[v]];
      CHECK(w.minCoeff() >= 0);
      CHECK(std::abs(w.sum() - 1) < 1e-14);
      const Vector3 at = w[0] * map.polycube[i] + w[1] * map.polycube[j] + w[2] * map.polycube[k];
      CHECK((at - mesh.polycube[v]).norm() < 1e-9);
    }
  }
}

namespace {

// How many triangles of the common mesh are not positive on the sphere, exactly.
std::size_t not_positive_on_sphere(const Morph& m) {
  std::size_t result = 0;
  for (const mesh::Triangle& t : m.triangles)
    result += mesh::orientation_from_origin(m.domain[t[0]], m.domain[t[1]], m.domain[t[2]]) <= 0;
  return result;
}

double diagonal_of(const mesh::Mesh& m) {
  const mesh::Measures box = mesh::measures(m.positions, m.triangles, base::Host());
  return (box.high - box.low).norm();
}

base::Array<TrianglePoint> vertices_of(const mesh::Mesh& m) {
  return points_of_vertices(m.positions.size(), m.triangles, base::Host());
}

// The farthest that the vertices of m are from where the points are on it.
double farthest(const mesh::Mesh& m, const base::Array<TrianglePoint>& points) {
  double result = 0;
  for (std::size_t v = 0; v < points.size(); ++v)
    result = std::max(result, (position_of(points[v], m.triangles, m.positions) - m.positions[v]).norm());
  return result;
}

}  // namespace

TEST_CASE("The map of a shape to itself is the identity, and the map back undoes the map there") {
  std::vector<mesh::Mesh> meshes{mesh::make_shape("l-shape", {.triangles = 300}, base::Host())};
  meshes.push_back(meshes[0]);
  for (Vector3& p : meshes[1].positions)
    p = Vector3(1.4 * p[0] + 0.1 * p[1], p[1], p[2] + 0.1 * std::sin(p[0]));
  const base::Host host;
  for (const Via via : {Via::sphere, Via::polycube}) {
    const Morph both = morph_of(meshes, {.via = via, .grid = CommonGrid::first});
    CHECK(both.maps->flipped() == 0);
    for (std::size_t i = 0; i < 2; ++i) {
      const double tolerance = 1e-9 * diagonal_of(meshes[i]);
      const base::Array<TrianglePoint> own = vertices_of(meshes[i]);
      CHECK(farthest(meshes[i], both.maps->carry(i, i, own, host)) < tolerance);
      const base::Array<TrianglePoint> there = both.maps->carry(i, 1 - i, own, host);
      for (const TrianglePoint& point : there) {
        REQUIRE(point.triangle < meshes[1 - i].triangles.size());
        CHECK(point.weights.minCoeff() >= 0);
        CHECK(std::abs(point.weights.sum() - 1) < 1e-12);
      }
      // Triangles may be a thousandth as wide there as here.
      CHECK(farthest(meshes[i], both.maps->carry(1 - i, i, there, host)) < 1000 * tolerance);
    }
  }
}

TEST_CASE("Points inside triangles are mapped where the common mesh has them") {
  const std::vector<mesh::Mesh> meshes{creature(0), creature(1)};
  const base::Host host;
  const Morph both = morph_of(meshes, {.tolerance = 0});
  const mesh::SurfaceSearch search(meshes[0].positions, meshes[0].triangles, host);
  base::Array<TrianglePoint> points;
  for (const Vector3& p : both.states[0]) {
    const mesh::SurfacePoint at = search.nearest(p);
    points.push_back({at.triangle, at.weights});
  }
  const base::Array<TrianglePoint> there = both.maps->carry(0, 1, points, host);
  const double diagonal = diagonal_of(meshes[1]);
  double largest = 0;
  for (std::size_t v = 0; v < points.size(); ++v)
    largest =
        std::max(largest, (position_of(there[v], meshes[1].triangles, meshes[1].positions) - both.states[1][v]).norm());
  CHECK(largest < 1e-6 * diagonal);
}

TEST_CASE("Inverted triangles of the input, and weights that are none, are seen in maps") {
  std::vector<mesh::Mesh> meshes{creature(0), creature(0)};
  for (mesh::Triangle& t : meshes[1].triangles)
    std::swap(t[1], t[2]);
  const base::Host host;
  const Morph both = morph_of(meshes, {.grid = CommonGrid::first});
  CHECK(farthest(meshes[1], both.maps->carry(0, 1, vertices_of(meshes[0]), host)) < 1e-9);
  const auto refused = [&](const TrianglePoint& point) {
    CHECK_THROWS_AS(both.maps->carry(0, 1, std::span(&point, 1), host), base::Error);
  };
  refused({static_cast<mesh::Index>(meshes[0].triangles.size()), {1, 0, 0}});
  refused({0, {0.5, 0.6, -0.1}});
  refused({0, {0.5, 0.4, 0.2}});
  refused({0, {std::nan(""), 1, 0}});
  CHECK_THROWS_AS(both.maps->carry(0, 2, {}, host), base::Error);
}

TEST_CASE("Ten shapes are blended on one triangulation, none of whose triangles is flipped") {
  std::vector<mesh::Mesh> meshes;
  std::vector<double> weights;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    meshes.push_back(mesh::make_shape("blob", {.triangles = 120, .seed = seed}, base::Host()));
    weights.push_back(0.1);
  }
  const Morph ten = morph_of(meshes, {.align = SphereAlignment::none});
  REQUIRE(ten.states.size() == 10);
  CHECK(not_positive_on_sphere(ten) == 0);
  const base::Array<Vector3> blended = blend(ten, weights, base::Host());
  Vector3 sum = Vector3::Zero();
  for (const auto& state : ten.states)
    sum += 0.1 * state[7];
  CHECK((blended[7] - sum).norm() < 1e-12);
}

TEST_CASE("Through a polycube, triangles are halves of quads, and copies get the same positions") {
  mesh::Mesh first = mesh::make_shape("l-shape", {.triangles = 300}, base::Host());
  mesh::Mesh copy = first;
  for (Vector3& p : copy.positions)
    p = 2 * Vector3(-p[1], p[0], p[2]) + Vector3(5, 6, 7);
  const Morph both = morph_of({first, copy}, {.via = Via::polycube, .pose = Pose::scaled, .cells = 300});
  REQUIRE(2 * both.quads.size() == both.triangles.size());
  for (std::size_t q = 0; q < both.quads.size(); ++q) {
    CHECK(both.triangles[2 * q] == mesh::Triangle{both.quads[q][0], both.quads[q][1], both.quads[q][2]});
    CHECK(both.triangles[2 * q + 1] == mesh::Triangle{both.quads[q][0], both.quads[q][2], both.quads[q][3]});
  }
  double largest = 0;
  for (std::size_t v = 0; v < both.states[0].size(); ++v)
    largest = std::max(largest, (both.states[0][v] - both.states[1][v]).norm());
  CHECK(largest < 1e-9);
}

TEST_CASE("Landmarks correspond, and grids of the sphere are triangulations of both shapes") {
  const std::vector<mesh::Mesh> meshes{creature(0), creature(0)};
  std::vector<std::vector<Vector3>> points(2);
  // Each landmark moves to a neighbor.
  for (const std::size_t t : {3U, 100U, 200U, 300U})
    for (std::size_t i = 0; i < 2; ++i)
      points[i].push_back(meshes[i].positions[meshes[i].triangles[t][i]]);
  const std::vector<std::span<const Vector3>> landmarks{points[0], points[1]};
  const Morph both = morph_of(meshes, {.grid = CommonGrid::icosphere, .resolution = 2, .landmarks = landmarks});
  CHECK(both.domain.size() == 162);
  CHECK(not_positive_on_sphere(both) == 0);
  const mesh::SurfaceSearch search(meshes[0].positions, meshes[0].triangles, base::Host());
  for (std::size_t k = 0; k < 4; ++k) {
    const mesh::SurfacePoint at = search.nearest(points[0][k]);
    const TrianglePoint from{at.triangle, at.weights};
    const TrianglePoint to = both.maps->carry(0, 1, std::span(&from, 1), base::Host())[0];
    CHECK((position_of(to, meshes[1].triangles, meshes[1].positions) - points[1][k]).norm() < 1e-6);
  }
}
