// Hexahedra from the cells of a grid in space: their topology, and meshes of them that are valid and near to the
// surface.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "base/error.h"
#include "hexmesh/grid/hex_grid.h"
#include "hexmesh/grid/voxel_hexes.h"
#include "hexmesh/strategies/hex_meshing.h"
#include "mesh/search/nearest.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/topology/cells.h"
#include "mesh/topology/topology.h"
#include "polycube/map/construction.h"
#include "tests/base/quiet_host.h"
#include "tests/volume_map/block_solid.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using namespace orbicube::volume_map;
using orbicube::test::host;
using volume_map::test::BlockSolid;

namespace {

mesh::Topology boundary_of(const HexMesh& hexes) {
  mesh::Mesh m;
  m.positions.assign(hexes.positions.begin(), hexes.positions.end());
  m.hexahedra.assign(hexes.hexahedra.begin(), hexes.hexahedra.end());
  return mesh::topology(m.positions, mesh::boundary_triangles(m, host), host);
}

}  // namespace

TEST_CASE("Cells of a grid become a conforming mesh whose quads are outward-oriented") {
  // A ring of eight around an empty one.
  std::vector<std::uint8_t> inside(9, 1);
  inside[4] = 0;
  const HexMesh mesh = hexahedra_of_cells({3, 3, 1}, inside, host);
  CHECK(mesh.hexahedra.size() == 8);
  CHECK(mesh.positions.size() == 32);
  CHECK(mesh.quads.size() == 8 + 8 + 12 + 4);
  CHECK(measure_hexahedra(mesh.positions, mesh.hexahedra, host).min_scaled_jacobian == 1);
  const auto halves = halves_of(mesh.quads, host.memory);
  const mesh::Topology topology = mesh::topology(mesh.positions, halves, host);
  CHECK(topology.genus == 1);
  CHECK(topology.volume == doctest::Approx(8));
}

TEST_CASE("About as many cells as requested, with the topology of the surface and a layer around") {
  for (const char* shape : {"sphere", "torus", "three-holes", "creature"}) {
    CAPTURE(std::string(shape));
    const mesh::Mesh surface = mesh::make_shape(shape, {.triangles = 3000}, host);
    const std::int64_t genus = *mesh::topology(surface.positions, surface.triangles, host).genus;
    const VoxelHexes voxels = voxel_hexahedra(surface.positions, surface.triangles, 3000, host);
    const std::size_t count = voxels.mesh.hexahedra.size();
    CHECK(count > 2000);
    CHECK(count < 4500);
    CHECK(voxels.padding == voxels.mesh.quads.size());
    const mesh::Topology topology = boundary_of(voxels.mesh);
    CHECK(topology.genus == genus);
    CHECK(topology.manifold());
    CHECK(topology.inconsistent_edges == 0);
    // No vertex of the surface is farther than two cells from the nearest cell.
    mesh::Mesh cells;
    cells.positions.assign(voxels.mesh.positions.begin(), voxels.mesh.positions.end());
    const auto halves = halves_of(voxels.mesh.quads, host.memory);
    const mesh::SurfaceSearch search(cells.positions, halves, host);
    for (const Vector3& p : surface.positions)
      CHECK(search.nearest(voxels.scale * p).distance < 2 * std::sqrt(3));
  }
}

TEST_CASE("Without a polycube, and where its hexahedra are poor, the cells of a grid in space are made to fit") {
  const mesh::Mesh surface = mesh::make_shape("creature", {.triangles = 2000}, host);
  const polycube::SurfaceMap none;
  const PolycubeSurface solid = {none, surface.positions, surface.triangles};
  const HexResult made = make_hexahedra(solid, {.cells = 1000, .rounds = 16, .distance = 3}, host);
  CHECK(made.grid_based);
  CHECK(made.padded);
  CHECK(made.quality.valid());
  CHECK(made.quality.mean_scaled_jacobian > 0.7);
  CHECK(made.distance <= 3);
  CHECK(made.volume_error <= 3);
  CHECK(boundary_of(made.mesh).genus == 0);
  CHECK_THROWS_AS(make_hexahedra(solid, {.method = HexMethod::polycube, .cells = 1000}, host), base::Error);

  // A map to a cube, of which all but a little is drawn out thin: nothing of that has room on the polycube.
  BlockSolid block({{0, 0, 0}}, 4, 0, 0);
  for (Vector3& p : block.map.positions)
    p[2] = p[2] < 1 ? 8 * p[2] : p[2] + 7;
  const PolycubeSurface thin = {block.map};
  CHECK(make_hexahedra(thin, {.cells = 300, .rounds = 4, .distance = 0}, host).grid_based);
  CHECK(!make_hexahedra(thin, {.method = HexMethod::polycube, .cells = 300, .rounds = 4, .distance = 0}, host)
             .grid_based);
}

TEST_CASE("Where a polycube serves its hexahedra stay, and are the same for any number of threads as those of a grid") {
  const BlockSolid block(volume_map::test::angle, 4, 0.5, 0.3);
  REQUIRE(block.certificate == "");
  CHECK(!make_hexahedra({block.map}, {.cells = 300, .rounds = 8, .distance = 0}, host).grid_based);
  std::vector<Vector3> first;
  for (const unsigned threads : {1U, 3U}) {
    base::Host with_threads;
    with_threads.thread_count = threads;
    const HexResult made = make_hexahedra(
        {block.map}, {.method = HexMethod::grid, .cells = 400, .rounds = 8, .distance = 0}, with_threads);
    CHECK(made.grid_based);
    if (threads == 1)
      first.assign(made.mesh.positions.begin(), made.mesh.positions.end());
    else
      CHECK(std::equal(first.begin(), first.end(), made.mesh.positions.begin(), made.mesh.positions.end()));
  }
}

TEST_CASE("The volume of a surface far from the origin keeps its digits") {
  mesh::Mesh surface = mesh::make_shape("torus", {.triangles = 300}, host);
  const polycube::SurfaceMap none;
  const double volume = TargetSurface({none, surface.positions, surface.triangles}).volume;
  CHECK(volume > 0);
  for (Vector3& p : surface.positions)
    p += Vector3(0x1p20, -0x1p21, 0x1p19);
  // Coordinates keep 30 digits (of two) there.
  CHECK(TargetSurface({none, surface.positions, surface.triangles}).volume == doctest::Approx(volume).epsilon(1e-7));
}
