// Polycubes changed for hexahedra: to the lengths and the sharp edges of the surface.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "hexmesh/grid/even_lengths.h"
#include "hexmesh/grid/sharp_map.h"
#include "hexmesh/strategies/hex_meshing.h"
#include "mesh/shapes/make_shape.h"
#include "polycube/map/certificate.h"
#include "polycube/map/construction.h"
#include "tests/volume_map/block_solid.h"

using namespace orbicube;
using namespace orbicube::hexmesh;
using namespace orbicube::volume_map;
using volume_map::test::BlockSolid;

TEST_CASE("Planes of a polycube are moved to where lengths on it are those in space") {
  const base::Host host;
  BlockSolid box({{0, 0, 0}}, 8, 0, 0);
  // Three times as long beyond the first quarter, and the whole half as high.
  for (std::size_t v = 0; v < box.map.positions.size(); ++v) {
    const Vector3 p = box.map.polycube[v];
    box.map.positions[v] = {p[0] + 2 * std::max(0.0, p[0] - 0.25), p[1], 0.5 * p[2]};
  }
  const polycube::SurfaceMap even = map_with_even_lengths(box.map, host);
  CHECK(std::equal(even.positions.begin(), even.positions.end(), box.map.positions.begin(), box.map.positions.end()));
  CHECK(std::equal(even.labels.begin(), even.labels.end(), box.map.labels.begin(), box.map.labels.end()));
  CHECK(std::equal(even.patches.begin(), even.patches.end(), box.map.patches.begin(), box.map.patches.end()));
  double largest = 0;
  for (std::size_t v = 0; v < even.positions.size(); ++v)
    largest = std::max(largest, (even.polycube[v] - even.positions[v]).norm());
  CHECK(largest < 1e-12);
}

TEST_CASE("Whatever the lengths in space, the polycube of even lengths is certified") {
  const base::Host host;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-3, 3);
  for (int run = 0; run < 20; ++run) {
    BlockSolid block(volume_map::test::angle, 2 + run % 4, 0.8, 0.4);
    block.cut(static_cast<unsigned>(run));
    for (Vector3& p : block.map.positions)
      p *= std::exp(exponent(random));
    const auto before = polycube::certify(block.map.polycube, block.map.triangles, host);
    polycube::SurfaceMap even = map_with_even_lengths(block.map, host);
    const auto after = polycube::certify(even.polycube, even.triangles, host);
    CHECK(after.valid());
    CHECK(after.corners == before.corners);
    CHECK(after.patch_count == before.patch_count);
    CHECK(std::equal(after.labels.begin(), after.labels.end(), before.labels.begin(), before.labels.end()));
  }
}

TEST_CASE(
    "Hexahedra of a right-angled solid are boxes up to its sharp edges, those of a smooth one have none to follow") {
  const base::Host host;
  const mesh::Mesh shape = mesh::make_shape("l-shape", {.triangles = 1200}, host);
  const auto best = polycube::construct(shape.positions, shape.triangles, {.corners = 60}, host);
  const HexResult made = make_hexahedra({best.made.map}, {.cells = 600}, host);
  CHECK(made.follows_sharp_edges);
  CHECK(made.quality.valid());
  CHECK(made.quality.min_scaled_jacobian > 0.99);
  CHECK(made.distance < 0.05);
  CHECK(made.volume_error < 0.01);
  const HexResult without = make_hexahedra({best.made.map}, {.cells = 600, .feature_angle = 0}, host);
  CHECK(without.quality.valid());
  CHECK(!without.follows_sharp_edges);
  CHECK(made.quality.min_scaled_jacobian >= without.quality.min_scaled_jacobian - 1e-6);
  const BlockSolid round(volume_map::test::angle, 4, 0.8, 0.4);
  CHECK(!map_with_sharp_edges(round.map, 100, host));
}

TEST_CASE("Sharp edges are left alone where the polycube has edges for less than three fifths of them") {
  const base::Host host;
  BlockSolid bar(volume_map::test::bar(2), 6, 0, 0);
  CHECK(map_with_sharp_edges(bar.map, 40, host));
  // Every second row of vertices across top and bottom becomes a ridge.
  for (std::size_t v = 0; v < bar.map.positions.size(); ++v) {
    const Vector3& p = bar.map.polycube[v];
    const bool ridge = std::lround(6 * p[0]) % 2 == 1 && (p[2] == 0 || p[2] == 1);
    if (ridge) bar.map.positions[v] += Vector3(0, 0, 0.1);
  }
  CHECK(!map_with_sharp_edges(bar.map, 40, host));
}
