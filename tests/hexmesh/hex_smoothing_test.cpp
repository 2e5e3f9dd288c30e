// Meshes of hexahedra made better: smoothed, searched, and brought to the surface.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "hexmesh/grid/hex_grid.h"
#include "hexmesh/grid/integer_domain.h"
#include "hexmesh/quality/hex_reach.h"
#include "hexmesh/quality/hex_search.h"
#include "hexmesh/quality/hex_smoothing.h"
#include "mesh/search/nearest.h"
#include "polycube/outputs/patch_graph.h"
#include "tests/volume_map/block_solid.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using namespace orbicube::volume_map;
using volume_map::test::BlockSolid;

namespace {

// Of a polycube with about that number of cells.
HexMesh grid_of(const polycube::SurfaceMap& map, std::size_t cells, double scale, const base::Host& host) {
  HexMesh mesh = sample_hexahedra(domain_of_cells(polycube::make_patch_graph(map, host), cells, 0, host), map, host);
  for (Vector3& p : mesh.positions)
    p *= scale;
  return mesh;
}

// With which those cells are about 1 long.
double scale_of_cells(const polycube::SurfaceMap& map, std::size_t cells, const base::Host& host) {
  double volume = 0;
  for (const mesh::Triangle& t : map.triangles)
    volume += map.positions[t[0]].dot(map.positions[t[1]].cross(map.positions[t[2]])) / 6;
  return std::cbrt(static_cast<double>(grid_of(map, cells, 1, host).hexahedra.size()) / volume);
}

// A grid on its way to be smoothed.
struct Draft {
  double scale;
  HexMesh mesh;
  SurfaceTarget target;
  HexBoundary boundary;

  Draft(const polycube::SurfaceMap& map, std::size_t cells, const base::Host& host)
      : scale(scale_of_cells(map, cells, host)),
        mesh(grid_of(map, cells, scale, host)),
        target(map, {}, {}, scale, host),
        boundary(mesh, target, host) {}

  bool smooth(const HexSmoothingOptions& options, const base::Host& host) {
    return smooth_hexahedra(mesh, boundary, target, options, host);
  }
};

}  // namespace

TEST_CASE("Smoothing leaves no hexahedron twisted where its corners are good") {
  struct Bar {
    double turn, taper;  // about its axis from end to end, and how wide the far end is
    std::size_t cells;
  };
  // Without the tetrahedra along edges three, one and seven hexahedra end so.
  for (const Bar& bar : {Bar{0, 0.02, 30}, Bar{8, 0.02, 150}, Bar{8, 2, 30}}) {
    BlockSolid block({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}}, 4, 0, 0);
    REQUIRE(block.certificate == "");
    // Bent to nearly a ring.
    for (std::size_t v = 0; v < block.map.positions.size(); ++v) {
      constexpr double angle = 5.5, length = 6, radius = length / angle;
      const Vector3& p = block.map.polycube[v];
      const double along = p[0] / length;
      const Vector3 across = (1 + (bar.taper - 1) * along) * (Eigen::AngleAxisd(bar.turn * along, Vector3::UnitX()) *
                                                              Vector3(0, p[1] - 0.5, p[2] - 0.5));
      block.map.positions[v] = Vector3((radius - across[1]) * std::sin(angle * along),
                                       radius - (radius - across[1]) * std::cos(angle * along), across[2]);
    }
    const base::Host host;
    Draft draft(block.map, bar.cells, host);
    CHECK(draft.smooth({.distance = 0.1}, host));
    for (const Hexahedron& h : draft.mesh.hexahedra) {
      CHECK(scaled_jacobian(draft.mesh.positions, h) > 0);
      CHECK(min_bezier(draft.mesh.positions, h) > 0);
    }
  }
}

TEST_CASE("The search makes hexahedra better on average, none worse than the worst, and leaves the boundary near") {
  BlockSolid block(volume_map::test::angle, 3, 0.8, 0.4);
  REQUIRE(block.certificate == "");
  const base::Host host;
  Draft draft(block.map, 400, host);
  REQUIRE(draft.smooth({}, host));
  const HexMesh& before = draft.mesh;
  const HexBoundary& boundary = draft.boundary;
  search_hexahedra(draft.mesh, boundary, {}, host);
  constexpr double reach = 0.2;
  const auto raised = [&](const HexSearchOptions& options) {
    HexMesh mesh(before);
    raise_mean(mesh, boundary, options, host);
    return mesh;
  };
  const auto quality = [&](const HexMesh& mesh) { return measure_hexahedra(mesh.positions, mesh.hexahedra, host); };
  const HexMesh after = raised({.mean_reach = reach});
  REQUIRE(quality(before).valid());
  CHECK(quality(after).valid());
  CHECK(quality(after).min_scaled_jacobian >= quality(before).min_scaled_jacobian);
  CHECK(quality(after).mean_scaled_jacobian > quality(before).mean_scaled_jacobian + 0.003);
  for (const Index v : boundary.vertices()) {
    // The last step puts vertices onto the surface.
    const double snapped = (boundary.project(v, after.positions[v]).position - after.positions[v]).norm();
    CHECK((after.positions[v] - before.positions[v]).norm() <= reach + 0.05 + snapped);
  }
  CHECK(raised({.mean_reach = reach}).positions == after.positions);
  // Where the boundary may not move at all, what is inside still may.
  const HexMesh inside = raised({.mean_reach = 0});
  CHECK(quality(inside).mean_scaled_jacobian > quality(before).mean_scaled_jacobian);
  CHECK(quality(inside).mean_scaled_jacobian < quality(after).mean_scaled_jacobian);
}

TEST_CASE(
    "A boundary that the surface is too far from somewhere is brought there, and stays valid and on the surface") {
  BlockSolid block(volume_map::test::angle, 4, 0.8, 0.4);
  REQUIRE(block.certificate == "");
  // A protrusion: what is near to a corner is drawn out.
  const Vector3 corner = block.map.positions[0];
  for (Vector3& p : block.map.positions)
    p += 0.5 * std::exp(-20 * (p - corner).squaredNorm()) * Vector3(-1, -1, -1);
  const base::Host host;
  Draft draft(block.map, 300, host);
  REQUIRE(draft.smooth({}, host));
  const HexMesh& mesh = draft.mesh;
  const HexBoundary& boundary = draft.boundary;
  const SurfaceTarget& target = draft.target;
  search_hexahedra(draft.mesh, boundary, {}, host);
  const auto farthest = [&](const HexMesh& of) {
    const Array<mesh::Triangle> halves = halves_of(of.quads, host.memory);
    const mesh::SurfaceSearch search(of.positions, halves, host);
    double most = 0;
    for (const Vector3& p : block.map.positions)
      most = std::max(most, search.nearest(draft.scale * p).distance);
    return most;
  };
  const auto quality = [&](const HexMesh& of) { return measure_hexahedra(of.positions, of.hexahedra, host); };
  REQUIRE(quality(mesh).valid());
  const double before = farthest(mesh);
  REQUIRE(before > 0.3);
  HexMesh near(mesh), far(mesh);
  reach_surface(near, boundary, target, 0.7 * before, host);
  CHECK(quality(near).valid());
  CHECK(quality(near).min_scaled_jacobian >= std::min(0.15, quality(mesh).min_scaled_jacobian));
  CHECK(farthest(near) < 0.8 * before);
  for (const Index v : boundary.vertices()) {
    if (near.positions[v] == mesh.positions[v]) continue;
    CHECK((boundary.project(v, near.positions[v]).position - near.positions[v]).norm() < 0.05);
  }
  HexMesh again(mesh);
  reach_surface(again, boundary, target, 0.7 * before, host);
  CHECK(again.positions == near.positions);
  // What is near enough is left alone.
  reach_surface(far, boundary, target, 2 * before, host);
  CHECK(far.positions == mesh.positions);
}
