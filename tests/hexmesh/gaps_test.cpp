// Solids with narrow gaps: both walls of a gap stay apart.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "bent_bar.h"
#include "hexmesh/certificate/hex_embedding.h"
#include "hexmesh/features/boundary_quads.h"
#include "hexmesh/grid/hex_grid.h"
#include "hexmesh/grid/voxel_hexes.h"
#include "hexmesh/quality/gap_opening.h"
#include "hexmesh/strategies/hex_meshing.h"
#include "mesh/search/intersections.h"
#include "mesh/search/nearest.h"
#include "mesh/topology/topology.h"
#include "tests/base/quiet_host.h"
#include "volume_map/solid/gap_widening.h"
#include "volume_map/solid/solid_polycube.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using namespace orbicube::volume_map;
using orbicube::test::host;

namespace {

HexQuality quality_of(const HexMesh& mesh) {
  HexQuality quality = measure_hexahedra(mesh.positions, mesh.hexahedra, host);
  measure_embedding(mesh.positions, mesh.quads, quality, host);
  return quality;
}

struct Surface {
  std::vector<Vector3> positions;
  std::vector<mesh::Triangle> triangles;
};

// A block 2 + gap wide, 2 high and 1 deep with a slit from above down to 1, of which all cells are cut in n^3.
Surface slit_block(double gap, int n, double leg = 1) {
  const std::array<int, 3> size = {3 * n, 2 * n, n};
  std::vector<std::uint8_t> inside;
  for (int x = 0; x < size[0]; ++x) {
    for (int y = 0; y < size[1]; ++y) {
      for (int z = 0; z < size[2]; ++z)
        inside.push_back(x / n == 1 && y / n == 1 ? 0 : 1);
    }
  }
  const HexMesh mesh = hexahedra_of_cells(size, inside, host);
  Surface surface;
  for (Vector3 p : mesh.positions) {
    p /= n;
    p[0] = p[0] < 1 ? leg * p[0] : p[0] < 2 ? leg + gap * (p[0] - 1) : leg + gap + leg * (p[0] - 2);
    surface.positions.push_back(p);
  }
  const auto halves = halves_of(mesh.quads, host.memory);
  surface.triangles.assign(halves.begin(), halves.end());
  return surface;
}

// Eight hexahedra around an edge along z, by an angle together, and turned from the bottom to the top: the first and
// the last quad share the edge, and are halves of one twisted quad or of the other.
HexMesh fan(double angle, double turned) {
  constexpr Index sectors = 8, layer = 2 * sectors + 2;
  const auto ray = [](Index k) { return 1 + k; };
  const auto diagonal = [](Index k) { return 2 + sectors + k; };
  HexMesh mesh(host.memory);
  for (const double z : {0.0, 1.0}) {
    const double step = angle / sectors, from = z * turned;
    mesh.positions.push_back({0, 0, z});
    for (Index k = 0; k <= sectors; ++k)
      mesh.positions.push_back({std::cos(from + k * step), std::sin(from + k * step), z});
    for (Index k = 0; k < sectors; ++k) {
      const double middle = from + (k + 0.5) * step;
      mesh.positions.push_back({1.2 * std::cos(middle), 1.2 * std::sin(middle), z});
    }
  }
  for (Index k = 0; k < sectors; ++k) {
    const std::array<Index, 4> q = {0, ray(k), diagonal(k), ray(k + 1)};
    mesh.hexahedra.push_back({q[0], q[1], q[2], q[3], layer + q[0], layer + q[1], layer + q[2], layer + q[3]});
  }
  for (const HexFace& face : faces_of(mesh.hexahedra, mesh.positions.size(), {}, host)) {
    if (face.second == no_index) mesh.quads.push_back(face.quad);
  }
  return mesh;
}

}  // namespace

TEST_CASE("Ends of a ring that lie in each other are moved apart, and nothing else is") {
  for (const double over : {0.001, 0.02, 0.05}) {
    HexMesh ring = hexmesh::test::bent_bar(24, 3, 2 * std::numbers::pi + over, host);
    const std::vector<Vector3> before(ring.positions.begin(), ring.positions.end());
    const HexQuality met = quality_of(ring);
    REQUIRE(met.positive());
    REQUIRE(met.intersections > 0);
    REQUIRE(open_gaps(ring, host));
    CHECK(quality_of(ring).valid());
    CHECK(quality_of(ring).min_scaled_jacobian > 0.5);
    std::size_t moved = 0;
    for (std::size_t v = 0; v < before.size(); ++v) {
      moved += ring.positions[v] != before[v];
      // As far as the ends lie in each other at the outer radius, and what is left between them.
      CHECK((ring.positions[v] - before[v]).norm() < 3 * over + 1e-3);
    }
    CHECK(moved > 0);
    CHECK(moved <= 64);  // 4 x 4 vertices at each end, and two layers further at most
  }
}

TEST_CASE("Quads that cross beside an edge that they share are turned about it") {
  constexpr double degree = std::numbers::pi / 180;
  for (const double twist : {4.0, 8.0, 16.0}) {
    const double between = twist / 16 * degree;
    const HexMesh before = fan(2 * std::numbers::pi - between, twist * degree);
    HexMesh mesh = fan(2 * std::numbers::pi - between, twist * degree);
    const HexQuality met = quality_of(mesh);
    REQUIRE(met.positive());
    REQUIRE(met.intersections > 0);
    REQUIRE(open_gaps(mesh, host));
    CHECK(quality_of(mesh).valid());
    CHECK(quality_of(mesh).min_scaled_jacobian > 0.5);
    for (std::size_t v = 0; v < before.positions.size(); ++v)
      CHECK((mesh.positions[v] - before.positions[v]).norm() < twist * degree);
  }
}

TEST_CASE("What meets nothing is left to the bit, and what cannot be parted is not said to be") {
  HexMesh open = hexmesh::test::bent_bar(24, 3, 6, host);
  const std::vector<Vector3> before(open.positions.begin(), open.positions.end());
  CHECK(open_gaps(open, host));
  CHECK(std::equal(before.begin(), before.end(), open.positions.begin(), open.positions.end()));
  // An eighth of a turn lies in the rest.
  HexMesh twice = hexmesh::test::bent_bar(24, 3, 2.25 * std::numbers::pi, host);
  const bool said = open_gaps(twice, host);
  CHECK(said == (quality_of(twice).intersections == 0));
  CHECK(quality_of(twice).positive());
}

TEST_CASE("Narrow gaps of a surface get wider, by no more than a third of what is behind their walls") {
  constexpr double gap = 0.01, width = 0.2;
  const Surface block = slit_block(gap, 4);
  const Array<Vector3> wider = widened_gaps(block.positions, block.triangles, width, host);
  REQUIRE(wider.size() == block.positions.size());
  for (std::size_t v = 0; v < wider.size(); ++v) {
    const Vector3 &p = block.positions[v], &q = wider[v];
    // The walls, without the floor's inner vertices, which are not at a wall.
    const bool wall = p[1] >= 1 && (p[0] == 1 || p[0] == 1 + gap);
    if (!wall) {
      CHECK(q == p);
      continue;
    }
    CHECK(std::abs(q[0] - (1 + gap / 2)) == doctest::Approx(width / 2));
    CHECK((q - p).cross(Vector3::UnitX()).norm() < 1e-12);
  }
  CHECK(widened_gaps(block.positions, block.triangles, gap / 2, host).empty());
  // Legs as thin as what the walls would move.
  const Surface thin = slit_block(gap, 4, 0.06);
  const Array<Vector3> little = widened_gaps(thin.positions, thin.triangles, width, host);
  REQUIRE(!little.empty());
  double most = 0;
  for (std::size_t v = 0; v < little.size(); ++v)
    most = std::max(most, (little[v] - thin.positions[v]).norm());
  CHECK(most == doctest::Approx(0.02));
}

TEST_CASE("Widened gaps are the same for any number of threads") {
  const Surface block = slit_block(0.01, 8);
  base::Host with_threads;
  with_threads.thread_count = 3;
  const Array<Vector3> one = widened_gaps(block.positions, block.triangles, 0.2, host);
  const Array<Vector3> three = widened_gaps(block.positions, block.triangles, 0.2, with_threads);
  CHECK(std::equal(one.begin(), one.end(), three.begin(), three.end()));
}

TEST_CASE("Grids of cells have both walls of a gap that is narrower than any cell") {
  const Surface block = slit_block(0.002, 4);
  const VoxelHexes cells = voxel_hexahedra(block.positions, block.triangles, 400, host);
  const auto halves = halves_of(cells.mesh.quads, host.memory);
  const mesh::Topology topology = mesh::topology(cells.mesh.positions, halves, host);
  CHECK(topology.genus == 0);
  CHECK(topology.manifold());
  CHECK(mesh::intersecting_quads(cells.mesh.positions, cells.mesh.quads, host).empty());
  // Not a block without a slit: from one leg to the other it is farther than across the gap.
  double between = 1;
  for (const Vector3& p : cells.mesh.positions) {
    const Vector3 at = p / cells.scale;
    if (at[1] > 1.5) between = std::min(between, std::abs(at[0] - 1.001));
  }
  CHECK(between > 0.01);
}

TEST_CASE("Grids of cells reach the end of a gap that is narrower than any cell, and has one") {
  // With the gap filled, the middle of its walls would be more than two cells inside.
  const Surface block = slit_block(0.002, 4);
  const VoxelHexes cells = voxel_hexahedra(block.positions, block.triangles, 1200, host);
  const auto halves = halves_of(cells.mesh.quads, host.memory);
  const mesh::SurfaceSearch search(cells.mesh.positions, halves, host);
  double most = 0;
  for (const mesh::Triangle& t : block.triangles) {
    const Vector3 center = (block.positions[t[0]] + block.positions[t[1]] + block.positions[t[2]]) / 3;
    most = std::max(most, search.nearest(cells.scale * center).distance);
  }
  CHECK(most < 1.5);
}

TEST_CASE("A solid with a narrow gap is filled without lying over itself, the same for any number of threads") {
  const Surface block = slit_block(0.004, 4);
  const polycube::SurfaceMap none;
  std::vector<Vector3> first;
  for (const unsigned threads : {1U, 3U}) {
    base::Host with_threads;
    with_threads.thread_count = threads;
    const HexResult made = make_hexahedra({none, block.positions, block.triangles},
                                          {.cells = 1000, .rounds = 12, .distance = 0}, with_threads);
    CHECK(made.quality.valid());
    CHECK(made.volume_error < 3);
    const auto halves = halves_of(made.mesh.quads, host.memory);
    CHECK(mesh::topology(made.mesh.positions, halves, host).genus == 0);
    if (threads == 1)
      first.assign(made.mesh.positions.begin(), made.mesh.positions.end());
    else
      CHECK(std::equal(first.begin(), first.end(), made.mesh.positions.begin(), made.mesh.positions.end()));
  }
}

TEST_CASE("The polycube of a surface with a narrow gap maps the surface as it is") {
  const Surface block = slit_block(0.002, 6);
  const polycube::Construction made = construct_polycube(block.positions, block.triangles, {}, host);
  CHECK(made.certificate.valid());
  CHECK(made.certificate.genus == 0);
  // Vertices of the input come first, to the bit; all others lie on its triangles.
  REQUIRE(made.map.positions.size() >= block.positions.size());
  CHECK(std::equal(block.positions.begin(), block.positions.end(), made.map.positions.begin()));
}
