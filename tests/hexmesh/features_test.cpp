// Sharp edges in hexahedral meshes: the bound on scaled Jacobians, what a mesh captures, and the choice between the
// mesh of a method and one with the feature graph embedded.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/error.h"
#include "base/random.h"
#include "feature_requests.h"
#include "hexmesh/captured/captured_features.h"
#include "hexmesh/captured/feature_bound.h"
#include "hexmesh/captured/feature_choice.h"
#include "hexmesh/features/feature_hexes.h"
#include "hexmesh/grid/hex_grid.h"
#include "hexmesh/hexmesh.h"
#include "hexmesh/strategies/machined_shape.h"
#include "mesh/shapes/make_shape.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using hexmesh::test::by_angles;
using orbicube::test::host;

namespace {

mesh::Mesh octahedron(double height) {
  mesh::Mesh m(host.memory);
  m.positions = {Vector3(1, 0, 0),  Vector3(0, 1, 0),      Vector3(-1, 0, 0),
                 Vector3(0, -1, 0), Vector3(0, 0, height), Vector3(0, 0, -height)};
  for (Index k = 0; k < 4; ++k) {
    m.triangles.push_back({k, (k + 1) % 4, 4});
    m.triangles.push_back({(k + 1) % 4, k, 5});
  }
  return m;
}

// The unit cube, of the hexahedra of a grid, and its surface.
HexMesh grid_cube(int n) {
  const std::vector<std::uint8_t> inside(static_cast<std::size_t>(n * n * n), 1);
  HexMesh mesh = hexahedra_of_cells({n, n, n}, inside, host);
  for (Vector3& p : mesh.positions)
    p /= n;
  return mesh;
}

mesh::Mesh cube_surface() {
  mesh::Mesh m(host.memory);
  const HexMesh cube = grid_cube(1);
  m.positions = cube.positions;
  m.triangles = halves_of(cube.quads, host.memory);
  return m;
}

}  // namespace

TEST_CASE("The distance of a convex hull is the largest minimum over directions") {
  const std::vector<Vector3> axes = {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
  CHECK(distance_of_hull(axes) == doctest::Approx(1 / std::numbers::sqrt3));
  CHECK(distance_of_hull(std::span(axes).first(2)) == doctest::Approx(1 / std::numbers::sqrt2));
  CHECK(distance_of_hull(std::span(axes).first(1)) == doctest::Approx(1));
  std::vector<Vector3> around = axes;
  around.emplace_back(-1, -1, -1);
  CHECK(distance_of_hull(around) == 0);
  // The minimum over vectors, for many directions, is no larger.
  const std::vector<Vector3> some = {Vector3(1, 0.2, 0.1), Vector3(0.3, 0.9, 0), Vector3(0.5, 0.4, 0.8),
                                     Vector3(0.7, 0.1, 0.6)};
  const double distance = distance_of_hull(some);
  double most = 0;
  for (int i = 0; i < 20000; ++i) {
    const double z = 1 - (i + 0.5) / 10000, a = i * std::numbers::pi * (3 - std::sqrt(5.0)), r = std::sqrt(1 - z * z);
    double least = 2;
    for (const Vector3& v : some)
      least = std::min(least, v.dot(Vector3(r * std::cos(a), r * std::sin(a), z)));
    most = std::max(most, least);
  }
  CHECK(most <= distance + 1e-12);
  CHECK(most > distance - 0.01);
}

TEST_CASE("The bound of a cube and of an octahedron") {
  // Three sectors of 90 degrees: sin 45 / sqrt 3.
  CHECK(scaled_jacobian_bound(feature_surface(cube_surface(), by_angles, host), host) ==
        doctest::Approx(1 / std::sqrt(6.0)));
  // Four sectors of 60 degrees, whose normals have the cosine 1 / sqrt 3 with the axis.
  CHECK(scaled_jacobian_bound(feature_surface(octahedron(1), by_angles, host), host) ==
        doctest::Approx(0.5 / std::numbers::sqrt3));
}

TEST_CASE("The edges of a cube are captured where the mesh has them, and named where not") {
  const FeatureSurface surface = feature_surface(cube_surface(), by_angles, host);
  CHECK(surface.pieces == 1);
  HexMesh cube = grid_cube(4);
  FeatureFigures figures;
  measure_captured(cube, surface, figures, host);
  CHECK(figures.curves == 12);
  CHECK(figures.corners == 8);
  CHECK(figures.captured == doctest::Approx(1));
  CHECK(figures.missing.empty());
  CHECK(missing_text(figures, 3).empty());
  // The corner at the origin and the middle vertices of an edge there, moved inside by a fifth of a cell.
  for (Vector3& p : cube.positions) {
    if (p.x() == 0 && p.y() == 0 && p.z() < 0.6) p += Vector3(0.05, 0.05, 0);
  }
  measure_captured(cube, surface, figures, host);
  CHECK(figures.captured < 1);
  CHECK(figures.captured > 1 - 1.0 / 12);
  CHECK(figures.missing_corners() == 1);
  REQUIRE(figures.missing_curves() >= 1);
  for (const MissingFeature& missing : figures.missing)
    CHECK(std::min(missing.from.norm(), missing.to.norm()) == 0);
  CHECK(missing_text(figures, 1).find("1 of 8 corners are missing") != std::string::npos);
}

TEST_CASE("The mesh that keeps more features is taken") {
  const mesh::Mesh surface = octahedron(1);
  FeatureKeeper keeper(surface, {.request = by_angles, .cells = 900}, host);
  REQUIRE(keeper.any());
  CHECK_FALSE(keeper.rectangular());  // four edges at a corner
  const std::optional<HexResult> made = keeper.embed();
  REQUIRE(made);
  CHECK(keeper.offer(*made, true, nullptr));
  CHECK(keeper.complete());
  const FeatureFigures figures = keeper.figures();
  CHECK(figures.replaced);
  CHECK(figures.captured == doctest::Approx(1));
  CHECK(made->quality.valid());
  CHECK(made->quality.min_scaled_jacobian <= figures.bound + 1e-9);
  CHECK(made->quality.min_scaled_jacobian > figures.bound - 0.05);
  // One that has lost a corner is not.
  HexResult other = *made;
  for (Vector3& p : other.mesh.positions)
    p.z() = std::min(p.z(), 0.95);
  CHECK_FALSE(keeper.offer(other, false, &*made));
  CHECK(keeper.complete());
  FeatureKeeper again(surface, {.request = by_angles, .cells = 900}, host);
  CHECK(again.offer(other, false, nullptr));
  CHECK_FALSE(again.complete());
  CHECK(again.figures().missing[0].why == "the method does not follow it, and the mesh is not to be replaced");
  CHECK(again.offer(*made, true, &other));
  CHECK(again.complete());
}

TEST_CASE("Of two meshes with all features the better one is taken, if one has a little less of their length") {
  const mesh::Mesh surface = cube_surface();
  FeatureKeeper keeper(surface, {.request = by_angles, .cells = 100, .distance = 1}, host);
  HexResult whole(host.memory), good(host.memory);
  whole.mesh = good.mesh = grid_cube(50);
  whole.quality.min_scaled_jacobian = 0.3;
  good.quality.min_scaled_jacobian = 0.7;
  for (Vector3& p : good.mesh.positions) {
    if (p.x() == 0 && p.y() == 0 && p.z() == 0.5) p.x() = 0.01;
  }
  CHECK(keeper.offer(whole, true, nullptr));
  CHECK(keeper.figures().captured == doctest::Approx(1));
  CHECK(keeper.offer(good, false, &whole));
  CHECK(keeper.figures().captured < 0.999);
  CHECK(keeper.complete());
  CHECK_FALSE(keeper.offer(whole, true, &good));
}

TEST_CASE("Edges of the mesh go to a sharp line that the graph does not have") {
  FeatureSurface surface = feature_surface(cube_surface(), by_angles, host);
  const FeatureSurface whole = surface;
  const mesh::FeatureArc& arc = surface.graph.arcs[0];
  const mesh::Edge edge = {surface.graph.vertices[arc.begin], surface.graph.vertices[arc.end - 1]};
  surface.graph = graph_without(surface, by_angles, std::span(&edge, 1), host);
  REQUIRE(surface.graph.arcs.size() == 11);
  REQUIRE(surface.graph.left_out.size() == 1);
  FeatureHexOptions options;
  options.cells = 500;
  options.max_cells = 2000;
  const FeatureHexes made = feature_hexahedra(surface.positions, surface.triangles, surface.graph, options, host);
  REQUIRE(made.found);
  FeatureFigures figures;
  measure_captured(made.result.mesh, whole, figures, host);
  CHECK(figures.curves == 12);
  CHECK(figures.captured > 0.95);  // 11 / 12 without that line, of which some hexahedra may not have their part
  CHECK(made.result.quality.valid());
}

TEST_CASE("A mesh too far from the surface gives way to one that is not, whatever it keeps") {
  const mesh::Mesh surface = cube_surface();
  FeatureKeeper keeper(surface, {.request = by_angles, .cells = 100, .distance = 1}, host);
  HexResult far(host.memory), near(host.memory);
  far.mesh = near.mesh = grid_cube(4);
  far.distance = 3;
  near.distance = 0.5;
  for (Vector3& p : near.mesh.positions) {
    if (p.norm() == 0) p += Vector3(0.1, 0.1, 0.1);
  }
  CHECK(keeper.offer(far, true, nullptr));
  CHECK(keeper.complete());
  CHECK(keeper.offer(near, false, &far));
  CHECK_FALSE(keeper.complete());
  CHECK_FALSE(keeper.offer(far, true, &near));
}

TEST_CASE("Right angles are those of a polycube") {
  CHECK(has_right_angles(feature_surface(cube_surface(), by_angles, host), host));
  CHECK_FALSE(has_right_angles(feature_surface(octahedron(1), by_angles, host), host));
}

TEST_CASE("Features of tags: of unknown vertices they are refused, and places have the scale of the input") {
  mesh::Mesh surface = cube_surface();
  for (Vector3& p : surface.positions)
    p *= 1000;
  volume_map::InputFindings findings;
  Options options;
  options.cells = 100;
  options.method = Method::polycube;
  options.features = Features::tags;
  // The diagonal of a face and a point on none of the tagged edges.
  std::vector<mesh::Edge> edges;
  for (const mesh::Triangle& t : surface.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 way = surface.positions[t[k]] - surface.positions[t[(k + 1) % 3]];
      if (edges.empty() && way.norm() > 1200) edges.push_back({t[k], t[(k + 1) % 3]});
    }
  }
  options.tagged_edges = edges;
  const Hexahedra made = make_hexahedra(surface, options, findings, host);
  REQUIRE(made.features);
  CHECK(made.features->curves >= 1);
  REQUIRE(made.features->missing_curves() >= 1);
  CHECK((made.features->missing[0].from - made.features->missing[0].to).norm() > 900);
  CHECK(made.method == Method::polycube);
  edges[0][0] = 100;
  options.tagged_edges = edges;
  CHECK_THROWS_AS(make_hexahedra(surface, options, findings, host), base::Error);
}

// A line within a patch has the same patch on both sides, and turns across the quads of a grid.
TEST_CASE("Hexahedra along a line that ends within a patch are as good as elsewhere") {
  constexpr Index parallels = 18, meridians = 36;
  constexpr double step = 2 * std::numbers::pi / meridians;
  mesh::Mesh sphere(host.memory);
  const auto put = [&](double polar, double azimuth) {
    const Vector3 p(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), std::cos(polar));
    sphere.positions.emplace_back(p.x(), 0.8 * p.y() - 0.6 * p.z(), 0.6 * p.y() + 0.8 * p.z());
  };
  for (Index i = 1; i < parallels; ++i) {
    for (Index k = 0; k < meridians; ++k)
      put(i * step, k * step);
  }
  put(0, 0);
  put(std::numbers::pi, 0);
  const auto north = static_cast<Index>(sphere.positions.size() - 2), south = north + 1;
  for (Index k = 0; k < meridians; ++k) {
    const Index next = (k + 1) % meridians, last = (parallels - 2) * meridians;
    sphere.triangles.push_back({north, k, next});
    sphere.triangles.push_back({last + next, last + k, south});
    for (Index row = 0; row < last; row += meridians) {
      sphere.triangles.push_back({row + k, row + meridians + k, row + next});
      sphere.triangles.push_back({row + next, row + meridians + k, row + meridians + next});
    }
  }
  std::vector<mesh::Edge> line;
  for (Index i = 3; i < 12; ++i)
    line.push_back({i * meridians + 2, (i + 1) * meridians + 2});
  volume_map::InputFindings findings;
  Options options;
  options.cells = 1500;
  options.method = Method::grid;
  options.features = Features::tags;
  options.tagged_edges = line;
  const Hexahedra made = make_hexahedra(sphere, options, findings, host);
  REQUIRE(made.features);
  CHECK(made.features->replaced);
  CHECK(made.features->captured > 0.99);
  CHECK(made.result.quality.min_scaled_jacobian > 0.3);
}

TEST_CASE("Machined parts keep their edges by default, other shapes and other strategies are as without features") {
  volume_map::InputFindings findings;
  Options options;
  options.cells = 300;
  options.distance = 0;
  options.rounds = 10;
  options.method = Method::grid;
  const Hexahedra machined = make_hexahedra(octahedron(1.2), options, findings, host);
  REQUIRE(machined.features);
  CHECK(machined.features->replaced);
  CHECK(machined.features->missing.empty());
  CHECK(machined.feature_angle == 35);
  options.feature_angle = 0;  // none is sharp
  CHECK_FALSE(make_hexahedra(octahedron(1.2), options, findings, host).features);
  options.feature_angle.reset();
  const mesh::Mesh round = mesh::make_shape("sphere", {.triangles = 500}, host);
  CHECK_FALSE(make_hexahedra(round, options, findings, host).features);
  // An edge that the input marks is a feature of any shape.
  const std::vector<mesh::Edge> tagged = {{round.triangles[0][0], round.triangles[0][1]}};
  options.tagged_edges = tagged;
  CHECK(make_hexahedra(round, options, findings, host).features);
  options.tagged_edges = {};
  options.method = Method::polycube;
  const Hexahedra on_polycube = make_hexahedra(cube_surface(), options, findings, host);
  CHECK_FALSE(on_polycube.features);
  CHECK(on_polycube.feature_angle == 40);
}

TEST_CASE("Sharp edges that are lines are distinguished from those of a rough surface") {
  // The sides of a tall cylinder bend by 30 degrees, and are much longer than its rims.
  mesh::Mesh column(host.memory);
  constexpr Index sides = 12;
  for (const double z : {0.0, 10.0}) {
    for (Index k = 0; k < sides; ++k)
      column.positions.emplace_back(std::cos(k * std::numbers::pi / 6), std::sin(k * std::numbers::pi / 6), z);
  }
  column.positions.emplace_back(0, 0, 0);
  column.positions.emplace_back(0, 0, 10);
  for (Index k = 0; k < sides; ++k) {
    const Index next = (k + 1) % sides;
    column.triangles.push_back({k, next, sides + k});
    column.triangles.push_back({next, sides + next, sides + k});
    column.triangles.push_back({next, k, 2 * sides});
    column.triangles.push_back({sides + k, sides + next, 2 * sides + 1});
  }
  CHECK_FALSE(is_machined(column.positions, column.triangles, host));
  CHECK(has_sharp_lines(column.positions, column.triangles, 35, host));
  std::mt19937_64 random(1);
  for (const double roughness : {0.03, 0.06, 0.15}) {
    mesh::Mesh rough = mesh::make_shape("sphere", {.triangles = 3000}, host);
    for (Vector3& p : rough.positions)
      p *= 1 + roughness * base::unit_interval(random());
    CHECK_FALSE(has_sharp_lines(rough.positions, rough.triangles, 35, host));
  }
  const mesh::Mesh round = mesh::make_shape("sphere", {.triangles = 3000}, host);
  CHECK_FALSE(has_sharp_lines(round.positions, round.triangles, 35, host));
}
