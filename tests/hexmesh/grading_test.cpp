// Graded grids for feature graphs: numbers of cells along the axes, surfaces with split edges, and a solid with a slot
// that cells of one size would have to be tiny for.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "base/random.h"
#include "feature_requests.h"
#include "hexmesh/captured/feature_bound.h"
#include "hexmesh/captured/feature_choice.h"
#include "hexmesh/features/feature_hexes.h"
#include "hexmesh/features/grading/graded_search.h"
#include "hexmesh/features/unfolding.h"
#include "hexmesh/grid/hex_grid.h"
#include "mesh/search/measures.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using hexmesh::test::by_angles;
using orbicube::test::host;

namespace {

// A block of 2.05 x 1.5 x 1 with a slot of 0.05 from above, half a unit deep.
mesh::Mesh slotted_block() {
  const std::vector<std::uint8_t> inside = {1, 1, 1, 1, 0, 1};
  const HexMesh cells = hexahedra_of_cells({3, 2, 1}, inside, host);
  constexpr std::array x = {0.0, 1.0, 1.05, 2.05}, y = {0.0, 1.0, 1.5, 1.5};
  mesh::Mesh m(host.memory);
  m.positions = cells.positions;
  for (Vector3& p : m.positions)
    p = Vector3(x[static_cast<std::size_t>(p.x())], y[static_cast<std::size_t>(p.y())], p.z());
  m.triangles = halves_of(cells.quads, host.memory);
  return m;
}

// Radius 1 about the z axis, with 96 sides.
mesh::Mesh cylinder() {
  constexpr Index sides = 96;
  mesh::Mesh m(host.memory);
  for (const double z : {0.0, 1.0}) {
    for (Index i = 0; i < sides; ++i) {
      const double angle = 2 * std::numbers::pi * i / sides;
      m.positions.emplace_back(std::cos(angle), std::sin(angle), z);
    }
  }
  for (Index i = 0; i < sides; ++i) {
    const Index j = (i + 1) % sides;
    m.triangles.push_back({i, j, sides + j});
    m.triangles.push_back({i, sides + j, sides + i});
    if (i == 0 || j == 0) continue;
    m.triangles.push_back({0, j, i});
    m.triangles.push_back({sides, sides + i, sides + j});
  }
  return m;
}

// 2 x 2 x 1, with a pit in the middle of its top: a pyramid upside down on an octagon of the given radius, whose walls
// turn by 31 degrees from one to the next and by 45 from the top.
mesh::Mesh block_with_pit(double radius) {
  mesh::Mesh m(host.memory);
  for (const double z : {1.0, 0.0}) {
    for (const auto& [x, y] : {std::pair(1.0, 1.0), std::pair(-1.0, 1.0), std::pair(-1.0, -1.0), std::pair(1.0, -1.0)})
      m.positions.emplace_back(x, y, z);
  }
  constexpr Index rim = 8, tip = 16;
  for (int k = 0; k < 8; ++k)
    m.positions.emplace_back(radius * std::cos(k * std::numbers::pi / 4), radius * std::sin(k * std::numbers::pi / 4),
                             1);
  m.positions.emplace_back(0, 0, 1 - radius * std::cos(std::numbers::pi / 8));
  for (Index k = 0; k < 8; ++k)
    m.triangles.push_back({rim + k, rim + (k + 1) % 8, tip});
  for (Index c = 0; c < 4; ++c) {
    const Index d = (c + 1) % 4, before = rim + 2 * c, middle = before + 1, after = rim + (2 * c + 2) % 8;
    m.triangles.push_back({before, c, middle});
    m.triangles.push_back({middle, c, after});
    m.triangles.push_back({c, d, after});
    m.triangles.push_back({d, c, c + 4});
    m.triangles.push_back({d, c + 4, d + 4});
  }
  m.triangles.push_back({4, 6, 5});
  m.triangles.push_back({4, 7, 6});
  return m;
}

double length_of_arcs(const mesh::FeatureGraph& graph, std::span<const Vector3> positions) {
  double sum = 0;
  for (const mesh::FeatureArc& arc : graph.arcs) {
    const auto v = graph.vertices_of(arc);
    for (std::size_t i = 1; i < v.size(); ++i)
      sum += (positions[v[i]] - positions[v[i - 1]]).norm();
  }
  return sum;
}

}  // namespace

TEST_CASE("An arc whose corners lie at one place requires no cells, and others are the most demanding") {
  const HexMesh cells = hexahedra_of_cells({1, 1, 1}, std::vector<std::uint8_t>{1}, host);
  const Array<mesh::Triangle> triangles = halves_of(cells.quads, host.memory);
  const mesh::FeatureGraph graph = mesh::feature_graph(cells.positions, triangles, {}, host);
  REQUIRE(graph.arcs.size() == 12);
  // The cube becomes a wedge that lacks its first edge.
  Array<Vector3> positions(cells.positions, host.memory);
  const auto& ends = graph.arcs[0].corners;
  positions[graph.corners[ends[0]].vertex] = positions[graph.corners[ends[1]].vertex];
  const FeatureShape shape(positions, triangles, graph, 10, host);
  REQUIRE(shape.length(0) == 0);
  const FeatureDemands demands(shape, 1, 2, host);
  const std::vector<double> strength(graph.arcs.size(), 1);
  // Three edges of 10 cells from each of the other corners are alike, those at the place where two are may be longer.
  const Array<Index> most = demands.most_demanding(strength, host);
  CHECK(std::ranges::count(most, Index{0}) == 0);
  CHECK(most.size() == 11);
  AxisGrading grading(Vector3(0, 0, 0), Vector3(10, 10, 10), 8, host);
  demands.refine(strength, 1, grading);
  CHECK(grading.size(Vector3(5, 5, 5)).minCoeff() == doctest::Approx(8));
}

TEST_CASE("A graded grid counts cells, and takes the count back") {
  AxisGrading grading(Vector3(0, 0, 0), Vector3(4, 2, 1), 0.25, host);
  CHECK((grading.cells(Vector3(4, 2, 1)) - Vector3(16, 8, 4)).norm() < 1e-9);
  grading.refine(Vector3(1, 1, 0.5), Vector3(1.1, 1, 0.5), 0.02);
  grading.spread();
  CHECK(grading.size(Vector3(1.05, 0, 0)).x() == doctest::Approx(0.02));
  CHECK(grading.size(Vector3(1.05, 0, 0)).y() == doctest::Approx(0.25));
  CHECK(grading.size(Vector3(3.9, 0, 0)).x() == doctest::Approx(0.25));
  // The segment has its cells, and the size grows by at most 0.4 of the way from it.
  const double across = grading.cells(Vector3(1.1, 0, 0)).x() - grading.cells(Vector3(1, 0, 0)).x();
  CHECK(across >= 5 - 1e-9);
  CHECK(grading.size(Vector3(1.3, 0, 0)).x() <= 0.02 + 0.4 * 0.2 + 1e-3);
  std::mt19937_64 random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto uniform = [&] { return 1.2 * base::unit_interval(random()) - 0.1; };
    const Vector3 p(4 * uniform(), 2 * uniform(), uniform());
    CHECK((grading.position(grading.cells(p)) - p).norm() < 1e-9);
  }
}

TEST_CASE("A surface with split edges is the same surface with the same graph") {
  const FeatureSurface surface = feature_surface(slotted_block(), by_angles, host);
  SplitSurface split(surface.positions, surface.triangles, surface.graph, host.memory);
  constexpr double most = 0.3;
  split_edges(
      split, [&](const Vector3& a, const Vector3& b) { return (a - b).norm() > most; }, host);
  CHECK(split.triangles.size() > 5 * surface.triangles.size());
  REQUIRE(split.graph.patches.size() == split.triangles.size());
  const mesh::Topology topology = mesh::topology(split.positions, split.triangles, host);
  CHECK(topology.euler_characteristic == 2);
  CHECK(topology.components == 1);
  CHECK(mesh::measures(split.positions, split.triangles, host).volume ==
        doctest::Approx(mesh::measures(surface.positions, surface.triangles, host).volume));
  CHECK(length_of_arcs(split.graph, split.positions) ==
        doctest::Approx(length_of_arcs(surface.graph, surface.positions)));
  std::map<Index, double> areas;
  for (std::size_t t = 0; t < split.triangles.size(); ++t) {
    const auto& [a, b, c] = split.triangles[t];
    const auto& p = split.positions;
    areas[split.graph.patches[t]] += 0.5 * (p[b] - p[a]).cross(p[c] - p[a]).norm();
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      CHECK((p[from] - p[to]).norm() <= most);
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const auto& p = surface.positions;
    areas[surface.graph.patches[t]] -= 0.5 * (p[b] - p[a]).cross(p[c] - p[a]).norm();
  }
  for (const auto& [patch, area] : areas)
    CHECK(std::abs(area) < 1e-9);
}

TEST_CASE("Cells along an arc are as small as its turns require") {
  constexpr double base = 0.8;
  const auto graded = [&](const mesh::Mesh& solid) {
    const FeatureSurface surface = feature_surface(solid, by_angles, host);
    const FeatureShape shape(surface.positions, surface.triangles, surface.graph, 1, host);
    AxisGrading grading(Vector3(-1, -1, 0), Vector3(1, 1, 1), base, host);
    const std::vector<double> none(surface.graph.arcs.size(), 1e-3);
    FeatureDemands(shape, base, base, host).refine(none, 1, grading);
    return grading;
  };
  const AxisGrading round = graded(cylinder());
  // 0.35 radians a cell, along the axis that the circle follows there.
  CHECK(round.size(Vector3(0, 1, 0)).x() == doctest::Approx(0.35).epsilon(0.05));
  CHECK(round.size(Vector3(1, 0, 0)).y() == doctest::Approx(0.35).epsilon(0.05));
  CHECK(round.size(Vector3(0, 0, 0.5)).z() == base);
  CHECK(graded(slotted_block()).size(Vector3(0, 0, 0.5)) == Vector3(base, base, base));
}

TEST_CASE("The rims of a cylinder are captured by few cells") {
  FeatureKeeper keeper(cylinder(), {.request = by_angles, .cells = 200}, host);
  const std::optional<HexResult> made = keeper.embed();
  REQUIRE(made);
  CHECK(made->quality.valid());
  CHECK(keeper.offer(*made, true, nullptr));
  CHECK(keeper.figures().captured > 0.99);
}

TEST_CASE("A part of closed arcs alone has no right angles for a polycube") {
  CHECK_FALSE(has_right_angles(feature_surface(cylinder(), by_angles, host), host));
}

TEST_CASE("A narrow slot costs cells across it alone") {
  FeatureKeeper keeper(slotted_block(), {.request = by_angles, .cells = 1000, .max_cells = 8000}, host);
  REQUIRE(keeper.any());
  const std::optional<HexResult> made = keeper.embed();
  REQUIRE(made);
  CHECK(made->quality.valid());
  // Cells of one size, two across the slot, would be 200,000.
  CHECK(made->mesh.hexahedra.size() < 8000);
  CHECK(keeper.offer(*made, true, nullptr));
  CHECK(keeper.complete());
  CHECK(keeper.figures().captured == doctest::Approx(1));
}

TEST_CASE("A rim of sides that are a fourth of a cell is captured") {
  FeatureKeeper keeper(block_with_pit(0.1), {.request = by_angles, .cells = 300}, host);
  REQUIRE(keeper.any());
  const std::optional<HexResult> made = keeper.embed();
  REQUIRE(made);
  CHECK(made->quality.valid());
  CHECK(made->mesh.hexahedra.size() < 2400);
  CHECK(keeper.offer(*made, true, nullptr));
  CHECK(keeper.figures().corners == 16);
  CHECK(keeper.complete());
  CHECK(keeper.figures().captured > 0.99);
}

TEST_CASE("What there are too few cells for is left out and named, and the rest is kept") {
  FeatureKeeper keeper(block_with_pit(0.1), {.request = by_angles, .cells = 200, .max_cells = 400}, host);
  const std::optional<HexResult> made = keeper.embed();
  REQUIRE(made);
  CHECK(made->quality.valid());
  CHECK(keeper.offer(*made, true, nullptr));
  const FeatureFigures figures = keeper.figures();
  // The edges of the block are 20 long, the rim is 0.61.
  CHECK(figures.captured > 0.96);
  // Edges of the mesh may have gone to some of the rim's eight sides and corners. All others are named, and only those.
  CHECK(figures.missing_curves() > 0);
  CHECK(figures.missing_curves() <= 8);
  double edges = 0;
  for (const Quad& q : made->mesh.quads) {
    for (std::size_t k = 0; k < 4; ++k)
      edges += (made->mesh.positions[q[k]] - made->mesh.positions[q[(k + 1) % 4]]).norm();
  }
  const double near = 0.1 * edges / static_cast<double>(4 * made->mesh.quads.size());
  std::size_t far_corners = 0;
  for (int k = 0; k < 8; ++k) {
    const Vector3 corner(0.1 * std::cos(k * std::numbers::pi / 4), 0.1 * std::sin(k * std::numbers::pi / 4), 1);
    far_corners += std::none_of(made->mesh.quads.begin(), made->mesh.quads.end(), [&](const Quad& q) {
      return std::any_of(q.begin(), q.end(),
                         [&](Index v) { return (made->mesh.positions[v] - corner).norm() <= near; });
    });
  }
  CHECK(far_corners > 0);
  CHECK(figures.missing_corners() == far_corners);
  for (const MissingFeature& missing : figures.missing) {
    CHECK(missing.from.head<2>().norm() == doctest::Approx(0.1));
    CHECK(missing.why.find("hexahedra, more than the 400 that") != std::string::npos);
  }
}

TEST_CASE("Grids of a search are given up where they have more cells than it may visit") {
  const FeatureSurface surface = feature_surface(slotted_block(), by_angles, host);
  FeatureHexOptions options;
  options.cells = 1000;
  options.max_cells = 8000;
  options.once = true;
  const FeatureHexes whole = feature_hexahedra(surface.positions, surface.triangles, surface.graph, options, host);
  REQUIRE(whole.found);
  REQUIRE(whole.visited > 0);
  options.max_visited = whole.visited;
  CHECK(feature_hexahedra(surface.positions, surface.triangles, surface.graph, options, host).found);
  options.max_visited = whole.visited - 1;
  const FeatureHexes less = feature_hexahedra(surface.positions, surface.triangles, surface.graph, options, host);
  CHECK_FALSE(less.found);
  CHECK(less.visited < whole.visited);
  CHECK_FALSE(less.obstacle.empty());
}

TEST_CASE("Cells become smaller where a patch bends between its arcs") {
  // A block of 2 x 2 x 1 whose top rises to a smooth hill in the middle.
  constexpr int sides = 24;
  const std::vector<std::uint8_t> inside(std::size_t{sides} * sides, 1);
  const HexMesh cells = hexahedra_of_cells({sides, sides, 1}, inside, host);
  mesh::Mesh hill(host.memory);
  for (const Vector3& p : cells.positions) {
    const double x = 2 * p.x() / sides - 1, y = 2 * p.y() / sides - 1;
    const double height = 0.7 * std::pow((1 - x * x) * (1 - y * y), 3);
    hill.positions.emplace_back(x, y, p.z() * (1 + height));
  }
  hill.triangles = halves_of(cells.quads, host.memory);
  const FeatureSurface surface = feature_surface(hill, by_angles, host);
  FeatureHexOptions options;
  options.cells = 400;
  options.max_cells = 1500;
  options.distance = 100;
  options.once = true;
  const FeatureHexes first = feature_hexahedra(surface.positions, surface.triangles, surface.graph, options, host);
  REQUIRE(first.found);
  options.distance = 2;
  CHECK(first.result.distance > options.distance);
  const FeatureHexes corrected = feature_hexahedra(surface.positions, surface.triangles, surface.graph, options, host);
  REQUIRE(corrected.found);
  CHECK(corrected.result.distance <= options.distance);
  options.once = false;
  const FeatureHexes made = feature_hexahedra(surface.positions, surface.triangles, surface.graph, options, host);
  REQUIRE(made.found);
  CHECK(made.result.quality.valid());
  CHECK(made.result.distance <= options.distance);
  // Smaller cells everywhere would have to be four times as many, more than there may be.
  CHECK(made.result.mesh.hexahedra.size() < 3 * first.result.mesh.hexahedra.size());
}

TEST_CASE("A twisted hexahedron is unfolded with those around it, and others stay") {
  const FeatureSurface surface = feature_surface(slotted_block(), by_angles, host);
  GradedSearch search(surface.positions, surface.triangles, surface.graph, 1000, 8000, 1e6, host);
  const std::optional<EmbeddedCells> found = search.next();
  REQUIRE(found);
  GradedCells& cells = *found->cells;
  HexMesh& mesh = cells.mesh();
  REQUIRE(fit_to_features(mesh, cells.sizes(), cells.targets(), {.rounds = 24}, host));
  const Array<Vector3> fitted = mesh.positions;
  REQUIRE(measure_hexahedra(mesh.positions, mesh.hexahedra, host).positive());
  // A hexahedron inside is twisted.
  const auto is_inside = [&](const Hexahedron& h) {
    return std::all_of(h.begin(), h.end(),
                       [&](Index v) { return cells.targets().kind(v) == FeatureTargets::Kind::inside; });
  };
  const auto inner = std::find_if(mesh.hexahedra.begin(), mesh.hexahedra.end(), is_inside);
  REQUIRE(inner != mesh.hexahedra.end());
  for (const std::size_t face : {std::size_t{0}, std::size_t{4}}) {
    const auto corner = [&](std::size_t k) -> const Vector3& { return fitted[(*inner)[face + k]]; };
    const Vector3 center = (corner(0) + corner(1) + corner(2) + corner(3)) / 4;
    const Vector3 axis = (corner(2) - corner(0)).cross(corner(3) - corner(1)).normalized();
    const Eigen::AngleAxisd turn(face == 0 ? -1.2 : 1.2, axis);
    for (std::size_t k = 0; k < 4; ++k)
      mesh.positions[(*inner)[face + k]] = center + turn * (corner(k) - center);
  }
  REQUIRE_FALSE(measure_hexahedra(mesh.positions, mesh.hexahedra, host).positive());
  CHECK(unfold_hexahedra(mesh, cells.sizes(), cells.targets(), host));
  CHECK(measure_hexahedra(mesh.positions, mesh.hexahedra, host).positive());
  std::size_t same = 0;
  for (std::size_t v = 0; v < fitted.size(); ++v)
    same += mesh.positions[v] == fitted[v] ? 1 : 0;
  CHECK(same > fitted.size() / 4);
}
