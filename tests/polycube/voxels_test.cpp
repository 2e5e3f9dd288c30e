// The parts of the voxel construction: what must hold whatever the shape.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "blocks.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/topology/topology.h"
#include "polycube/layout/layout.h"
#include "polycube/voxels/grid_rectangles.h"
#include "polycube/voxels/local_thickness.h"
#include "polycube/voxels/occupancy.h"
#include "polycube/voxels/simplification.h"
#include "polycube/voxels/voxel_solid.h"
#include "polycube/voxels/voxelisation.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::polycube;
using test::host;

namespace {

VoxelSolid empty_solid(int cells) {
  std::array<Array<double>, 3> planes;
  for (auto& axis : planes)
    for (int i = 0; i <= cells; ++i)
      axis.push_back(i);
  return VoxelSolid(std::move(planes), host.memory);
}

// Cells shifted by one, so that the outermost layer is empty.
VoxelSolid solid_of(const std::vector<test::Cell>& cells, int size) {
  VoxelSolid solid = empty_solid(size + 2);
  for (const test::Cell& c : cells)
    solid.set(solid.place({c[0] + 1, c[1] + 1, c[2] + 1}), true);
  return solid;
}

bool certified(const VoxelSolid& solid, std::int64_t genus) {
  const VoxelTopology t = solid.topology(host);
  return t.bad_vertices == 0 && t.genus == genus && t.inside_components == 1 && t.outside_components == 1;
}

Voxelisation voxels_of(const mesh::Mesh& shape, std::int64_t genus) {
  const Occupancy occupancy(shape.positions, shape.triangles, 96, host);
  VoxelisationOptions options;
  options.min_cells = 24;
  return voxelise(shape.positions, shape.triangles, genus, occupancy, options, host);
}

}  // namespace

TEST_CASE("Configurations of cells are manifold and corners as counted by hand") {
  CHECK(VoxelSolid::manifold(0b00000001));
  CHECK(VoxelSolid::corner(0b00000001));
  CHECK(VoxelSolid::manifold(0b00000011));
  CHECK_FALSE(VoxelSolid::corner(0b00000011));    // along an edge
  CHECK_FALSE(VoxelSolid::corner(0b00001111));    // within a face
  CHECK_FALSE(VoxelSolid::manifold(0b00001001));  // two cells that touch along an edge
  CHECK_FALSE(VoxelSolid::manifold(0b10000001));  // and at a point
  CHECK(VoxelSolid::corner(0b00000111));          // three cells, an L
  for (unsigned c = 0; c < 256; ++c)
    CHECK(VoxelSolid::manifold(c) == VoxelSolid::manifold(255 & ~c));
}

TEST_CASE("Blocks have the topology that they must have") {
  CHECK(certified(solid_of(test::box_without({3, 2, 4}), 4), 0));
  CHECK(certified(solid_of(test::box_without({3, 3, 1}, {{1, 1, 0}}), 3), 1));
  CHECK(certified(solid_of(test::box_without({5, 3, 1}, {{1, 1, 0}, {3, 1, 0}}), 5), 2));
  CHECK(solid_of(test::box_without({3, 3, 1}, {{1, 1, 0}}), 3).corners() == 16);
  // A cavity is a second outside component.
  CHECK(solid_of(test::box_without({3, 3, 3}, {{1, 1, 1}}), 3).topology(host).outside_components == 2);
}

TEST_CASE("Simple flips in any order keep the topology and count corners") {
  VoxelSolid solid = solid_of(test::box_without({6, 6, 3}, {{2, 2, 0}, {2, 2, 1}, {2, 2, 2}}), 6);
  REQUIRE(certified(solid, 1));
  auto corners = static_cast<std::int64_t>(solid.corners());
  std::mt19937_64 random(7);
  std::size_t flips = 0;
  for (int i = 0; i < 20000; ++i)
    flips += solid.flip_if_simple(solid.cell(random() % solid.size()), corners);
  REQUIRE(flips > 500);
  CHECK(certified(solid, 1));
  CHECK(corners == static_cast<std::int64_t>(solid.corners()));
}

TEST_CASE("Cells inside a box are counted exactly, and none of a hole") {
  const mesh::Mesh box = test::blocks(test::box_without({4, 2, 3}));
  const Occupancy whole(box.positions, box.triangles, 40, host);
  CHECK(whole.inside({0, 0, 0}, {40, 40, 40}) == 40 * 20 * 30);
  CHECK(whole.inside({5, 5, 5}, {7, 8, 9}) == 2 * 3 * 4);
  const mesh::Mesh ring = test::blocks(test::box_without({3, 3, 1}, {{1, 1, 0}}));
  const Occupancy holed(ring.positions, ring.triangles, 30, host);
  CHECK(holed.inside({10, 10, 0}, {20, 20, 10}) == 0);
  CHECK(holed.inside({0, 0, 0}, {30, 30, 10}) == 8000);
}

TEST_CASE("Slabs cover a set of squares once") {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<std::array<int, 2>> squares;
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j)
        if (random() % 3 > 0) squares.push_back({i, j});
    base::Array<GridRectangle> slabs;
    cut_into_slabs(squares, slabs);
    std::vector<std::array<int, 2>> covered;
    for (const GridRectangle& r : slabs)
      for (int i = r.low[0]; i < r.high[0]; ++i)
        for (int j = r.low[1]; j < r.high[1]; ++j)
          covered.push_back({i, j});
    std::sort(covered.begin(), covered.end());
    CHECK(covered == squares);
  }
}

TEST_CASE("A slab's thickness is half its height, also far from its middle") {
  std::vector<test::Cell> cells = test::box_without({12, 12, 3});
  const VoxelSolid solid = solid_of(cells, 12);
  const Array<float> thickness = local_thickness(solid, host);
  // Two cells from the middle layer to the first outside one.
  CHECK(thickness[solid.place({6, 6, 2})] == doctest::Approx(2));
  CHECK(thickness[solid.place({6, 6, 1})] == doctest::Approx(2));
  CHECK(thickness[solid.place({6, 6, 0})] == doctest::Approx(2));  // outside, beside it
  CHECK(*std::min_element(thickness.begin(), thickness.end()) > 0);
}

TEST_CASE("Shapes of every genus get voxels of that genus, and any budget of corners that they reach keeps it" *
          doctest::test_suite("long")) {
  for (const mesh::ShapeDescription& description : mesh::shapes()) {
    CAPTURE(description.name);
    mesh::ShapeOptions options;
    options.triangles = 3000;
    const mesh::Mesh shape = mesh::make_shape(description.name, options, host);
    const Voxelisation voxels = voxels_of(shape, description.genus);
    CHECK(certified(voxels.solid, description.genus));
    Simplification simplification(voxels, host);
    for (const std::size_t corners : {60U, 20U, 8U}) {
      if (!simplification.reduce(corners)) break;
      CHECK(simplification.corners() <= corners);
      CHECK(simplification.corners() == simplification.solid().corners());
      CHECK(certified(simplification.solid(), description.genus));
    }
    if (description.genus == 0) CHECK(simplification.corners() == 8);
  }
}

TEST_CASE("Layouts are closed surfaces of rectangles with the corners of their solids") {
  struct Case {
    std::vector<test::Cell> cells;
    std::int64_t genus;
    std::size_t corners, rectangles;
  };
  const std::vector<Case> cases = {
      {test::box_without({2, 3, 4}), 0, 8, 6},
      {test::box_without({2, 2, 1}, {{1, 1, 0}}), 0, 12, 10},
      {test::box_without({3, 3, 1}, {{1, 1, 0}}), 1, 16, 16},
      {test::box_without({5, 3, 2}, {{1, 1, 0}, {1, 1, 1}, {3, 1, 0}, {3, 1, 1}}), 2, 24, 0},
  };
  for (const Case& c : cases) {
    const Layout layout = make_layout(solid_of(c.cells, 5), host);
    CHECK(layout.corners() == c.corners);
    if (c.rectangles > 0) CHECK(layout.rectangles.size() == c.rectangles);
    const auto euler = static_cast<std::int64_t>(layout.nodes.size() + layout.rectangles.size()) -
                       static_cast<std::int64_t>(layout.arcs());
    CHECK(euler == 2 - 2 * c.genus);
    std::size_t sides = 0;
    for (Index r = 0; r < layout.rectangles.size(); ++r) {
      const auto around = layout.darts_around(r);
      sides += around.size();
      for (std::size_t i = 0; i < around.size(); ++i) {
        CHECK(layout.dart_left[around[i]] == r);
        CHECK(layout.target(around[i]) == layout.origin(around[(i + 1) % around.size()]));
      }
    }
    CHECK(sides == 2 * layout.arcs());
    for (Index n = 0; n < layout.nodes.size(); ++n) {
      CHECK(layout.darts_of(n).size() >= 3);
      for (const Index dart : layout.darts_of(n))
        CHECK(layout.origin(dart) == n);
    }
  }
}
