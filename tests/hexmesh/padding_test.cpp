// Layers of hexahedra along the boundary.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <array>
#include <bit>
#include <cmath>

#include "hexmesh/grid/hex_grid.h"
#include "hexmesh/grid/integer_domain.h"
#include "hexmesh/grid/padding.h"
#include "mesh/topology/cells.h"
#include "polycube/outputs/patch_graph.h"
#include "tests/volume_map/block_solid.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using namespace orbicube::volume_map;
using volume_map::test::BlockSolid;

namespace {

HexMesh grid_of(const BlockSolid& block, double cell_length) {
  const base::Host host;
  const IntegerDomain domain(polycube::make_patch_graph(block.map, host), cell_length, host);
  return sample_hexahedra(domain, block.map, host);
}

}  // namespace

TEST_CASE("A layer on any of the faces of a box leaves a conforming mesh with the same boundary") {
  const base::Host host;
  const BlockSolid box({{0, 0, 0}}, 3, 0, 0);
  REQUIRE(box.certificate == "");
  const HexMesh grid = grid_of(box, 1.0 / 3);
  REQUIRE(grid.hexahedra.size() == 27);
  for (unsigned faces = 0; faces < 64; ++faces) {
    std::array<std::uint8_t, 6> padded{};
    for (std::size_t k = 0; k < 6; ++k)
      padded[k] = (faces >> k) & 1;
    HexMesh made = grid;
    pad(made, padded, 1.0 / 3, host);
    CHECK(made.hexahedra.size() == 27 + 9 * static_cast<std::size_t>(std::popcount(faces)));
    const HexQuality quality = measure_hexahedra(made.positions, made.hexahedra, host);
    CHECK(quality.valid());
    CHECK(quality.volume == doctest::Approx(measure_hexahedra(grid.positions, grid.hexahedra, host).volume));
    mesh::Mesh cells;
    cells.positions = made.positions;
    cells.hexahedra = made.hexahedra;
    mesh::require_valid_cells(cells, host);
    CHECK(mesh::boundary_triangles(cells, host).size() == 2 * made.quads.size());
    // What a quad says it lies on is where it lies; outward.
    REQUIRE(made.quads.size() == made.quad_patches.size());
    std::array<double, 6> area{};
    for (std::size_t i = 0; i < made.quads.size(); ++i) {
      const Quad& q = made.quads[i];
      const Vector3 normal =
          0.5 * (made.positions[q[2]] - made.positions[q[0]]).cross(made.positions[q[3]] - made.positions[q[1]]);
      area[made.quad_patches[i]] += normal.norm();
      for (std::size_t j = 0; j < grid.quads.size(); ++j) {
        if (grid.quad_patches[j] != made.quad_patches[i]) continue;
        const Quad& g = grid.quads[j];
        const Vector3 out =
            (grid.positions[g[2]] - grid.positions[g[0]]).cross(grid.positions[g[3]] - grid.positions[g[1]]);
        CHECK(out.normalized().dot(normal.normalized()) == doctest::Approx(1));
        for (const Index v : q)
          CHECK(std::abs(out.dot(made.positions[v] - grid.positions[g[0]])) < 1e-12);
        break;
      }
    }
    for (const double a : area)
      CHECK(a == doctest::Approx(1));
  }
}

TEST_CASE("Faces that meet in right angles are not padded, round ones are, and those along an inner edge alike") {
  const base::Host host;
  const BlockSolid sharp(volume_map::test::angle, 4, 0, 0);
  for (const std::uint8_t face : choose_padding(grid_of(sharp, 0.25), host))
    CHECK(face == 0);
  // A block in the shape of a ball.
  BlockSolid round({{0, 0, 0}}, 6, 0, 0);
  for (std::size_t v = 0; v < round.map.positions.size(); ++v) {
    const Vector3 p = 2 * round.map.polycube[v] - Vector3::Ones();
    round.map.positions[v] = p.lpNorm<Eigen::Infinity>() * p.normalized();
  }
  const auto all = choose_padding(grid_of(round, 1.0 / 6), host);
  CHECK(all.size() == 6);
  for (const std::uint8_t face : all)
    CHECK(face == 1);
  // One whose upper face is a dome that goes on into its neighbors, which meet the lower one at right angles.
  BlockSolid dome({{0, 0, 0}}, 6, 0, 0);
  for (std::size_t v = 0; v < dome.map.positions.size(); ++v) {
    Vector3 p = dome.map.polycube[v];
    const double edge = std::max(std::abs(p[0] - 0.5), std::abs(p[1] - 0.5));
    p[2] *= std::sqrt(1.25 - 4 * edge * edge);
    dome.map.positions[v] = p;
  }
  const HexMesh grid = grid_of(dome, 1.0 / 6);
  const auto some = choose_padding(grid, host);
  std::size_t lower = 0, upper = 0;
  for (std::size_t i = 0; i < grid.quads.size(); ++i) {
    double low = 2, high = 0;
    for (const Index v : grid.quads[i]) {
      low = std::min(low, grid.positions[v][2]);
      high = std::max(high, grid.positions[v][2]);
    }
    if (high == 0) {
      CHECK(some[grid.quad_patches[i]] == 0);
      ++lower;
    }
    if (low > 0.9) {
      CHECK(some[grid.quad_patches[i]] == 1);
      ++upper;
    }
  }
  CHECK(lower == 36);
  CHECK(upper >= 4);
}
