// The regular triangulations of the sphere.
#include "sphere_map/sampling/grids.h"

#include <doctest/doctest.h>

#include <limits>
#include <set>

#include "base/error.h"
#include "mesh/topology/topology.h"
#include "sphere_map/optimization/measure.h"

using namespace orbicube;
using sphere_map::Grid;
using sphere_map::GridKind;

TEST_CASE("Each grid is a closed sphere of unit vectors, every triangle positive exactly, covered once") {
  struct Row {
    GridKind kind;
    std::size_t resolution, vertices;
  };
  for (const Row& row :
       {Row{GridKind::icosphere, 0, 12}, Row{GridKind::icosphere, 1, 42}, Row{GridKind::icosphere, 2, 162},
        Row{GridKind::icosphere, 5, 10242}, Row{GridKind::cube, 1, 8}, Row{GridKind::cube, 2, 26},
        Row{GridKind::cube, 7, 296}, Row{GridKind::cube, 40, 9602}, Row{GridKind::latitude, 2, 6},
        Row{GridKind::latitude, 3, 14}, Row{GridKind::latitude, 50, 4902}, Row{GridKind::octahedron, 2, 6},
        Row{GridKind::octahedron, 4, 18}, Row{GridKind::octahedron, 64, 4098}}) {
    CAPTURE(static_cast<int>(row.kind));
    CAPTURE(row.resolution);
    const Grid grid = sphere_map::make_grid(row.kind, row.resolution, base::Host());
    CHECK(grid.directions.size() == row.vertices);
    const mesh::Topology facts = mesh::topology(grid.directions, grid.triangles, base::Host());
    CHECK_NOTHROW(mesh::require_closed_genus_zero(facts));
    CHECK(facts.unreferenced_vertices == 0);
    CHECK(facts.coincident_vertices == 0);
    CHECK(sphere_map::count_not_positive(grid.triangles, grid.directions) == 0);
    const auto m = sphere_map::measure(grid.directions, grid.triangles, grid.directions, 0.1, 1, base::Host());
    CHECK(m.bijective);
    CHECK(m.radius_error < 3e-16);
  }
}

TEST_CASE("The triangles of an icosphere are nearly alike, and those of a cube not far from it") {
  // Largest over smallest area: 1.25 or so in the limit, and 2.3 for the two triangles of a cube's quads.
  for (const auto& [kind, resolution, most] : {std::tuple{GridKind::icosphere, 5, 1.35}, {GridKind::cube, 32, 1.9}}) {
    const Grid grid = sphere_map::make_grid(kind, static_cast<std::size_t>(resolution), base::Host());
    double least = 1e9, largest = 0;
    for (const auto& [a, b, c] : grid.triangles) {
      const double area = sphere_map::solid_angle(grid.directions[a], grid.directions[b], grid.directions[c]);
      least = std::min(least, area);
      largest = std::max(largest, area);
    }
    CHECK(largest / least < most);
  }
}

TEST_CASE(
    "The square of the octahedron has each vertex once inside, twice at its sides and four times at the corners") {
  for (const std::size_t n : {2U, 4U, 10U}) {
    const std::size_t vertices = n * n + 2;
    std::vector<int> times(vertices, 0);
    for (std::size_t row = 0; row <= n; ++row) {
      for (std::size_t column = 0; column <= n; ++column)
        ++times.at(sphere_map::octahedron_vertex(n, column, row));
    }
    CHECK(times[0] == 4);
    for (std::size_t i = 1; i <= n; ++i) {
      // The middle of a side is folded onto itself.
      const auto at_top = times[sphere_map::octahedron_vertex(n, std::min(i, n - 1), 0)];
      CHECK(at_top == (2 * std::min(i, n - 1) == n ? 1 : 2));
    }
    for (const int t : times)
      CHECK(t > 0);
    CHECK(sphere_map::octahedron_vertex(n, 1, 0) == sphere_map::octahedron_vertex(n, n - 1, 0));
    CHECK(sphere_map::octahedron_vertex(n, 0, 1) == sphere_map::octahedron_vertex(n, 0, n - 1));
    CHECK(sphere_map::octahedron_vertex(n, 1, 0) != sphere_map::octahedron_vertex(n, 1, n));
  }
}

TEST_CASE("Resolutions out of range are refused") {
  for (const auto& [kind, resolution] : {std::pair{GridKind::icosphere, std::size_t{11}},
                                         {GridKind::cube, std::size_t{0}},
                                         {GridKind::latitude, std::size_t{1}},
                                         {GridKind::octahedron, std::size_t{3}},
                                         {GridKind::cube, std::numeric_limits<std::size_t>::max()},
                                         {static_cast<GridKind>(9), std::size_t{4}}}) {
    CHECK_THROWS_AS(sphere_map::make_grid(kind, resolution, base::Host()), base::Error);
  }
}
