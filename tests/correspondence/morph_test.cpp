// Shapes on one triangulation: the same bits for any number of threads, exact ends of blends, and itself for itself.
#include "correspondence/morph.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "base/error.h"
#include "correspondence/polycube_mesh.h"
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
