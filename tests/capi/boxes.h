// A box of tetrahedra, its surface, and two of these: shapes of the tests of volume_map and hexmesh.
#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "orbicube/mesh.h"

namespace orbicube::test {

// Appends six positive tetrahedra about the diagonal of the cube from `low`, where at(place) is the number of a vertex.
template <class At>
void append_cube(const std::array<int, 3>& low, const At& at, std::vector<std::uint32_t>& tetrahedra) {
  constexpr int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
  for (int o = 0; o < 6; ++o) {
    std::array<int, 3> p = low;
    std::uint32_t t[4] = {at(p), 0, 0, 0};
    for (int k = 0; k < 3; ++k) {
      ++p[static_cast<std::size_t>(orders[o][k])];
      t[k + 1] = at(p);
    }
    if (o >= 3) std::swap(t[2], t[3]);
    tetrahedra.insert(tetrahedra.end(), t, t + 4);
  }
}

// A box of 3 x 2 x 2 cubes, each of six tetrahedra; its boundary is fixed, vertices inside are at one corner.
struct Box {
  std::vector<double> rest, start;
  std::vector<std::uint32_t> tetrahedra;
  std::vector<std::uint8_t> fixed;

  Box() {
    const auto at = [](const std::array<int, 3>& p) {
      return static_cast<std::uint32_t>((p[0] * 3 + p[1]) * 3 + p[2]);
    };
    for (int x = 0; x <= 3; ++x) {
      for (int y = 0; y <= 2; ++y) {
        for (int z = 0; z <= 2; ++z) {
          const bool inside = x > 0 && x < 3 && y == 1 && z == 1;
          for (const int c : {x, y, z}) {
            rest.push_back(c);
            start.push_back(inside ? 0 : c);
            fixed.push_back(!inside);
          }
          if (x < 3 && y < 2 && z < 2) append_cube({x, y, z}, at, tetrahedra);
        }
      }
    }
  }

  obc_mesh* mesh() const {
    obc_mesh_cells cells;
    REQUIRE(obc_mesh_cells_init(&cells, sizeof cells) == OBC_OK);
    cells.positions = rest.data();
    cells.vertex_count = rest.size() / 3;
    cells.tetrahedra = tetrahedra.data();
    cells.tetrahedron_count = tetrahedra.size() / 4;
    obc_mesh* result = nullptr;
    REQUIRE(obc_mesh_create(&cells, nullptr, &result, nullptr) == OBC_OK);
    return result;
  }
};

// Its surface, with what keeps it.
struct BoxSurface {
  obc_mesh* mesh = nullptr;
  obc_surface surface{};

  BoxSurface() {
    obc_mesh* const solid = Box().mesh();
    REQUIRE(obc_mesh_boundary(solid, nullptr, &mesh, nullptr) == OBC_OK);
    obc_mesh_destroy(solid);
    REQUIRE(obc_mesh_surface(mesh, &surface, nullptr) == OBC_OK);
  }
  BoxSurface(const BoxSurface&) = delete;
  BoxSurface& operator=(const BoxSurface&) = delete;
  ~BoxSurface() { obc_mesh_destroy(mesh); }
};

// The surface of the box, 3 by 2 by 2, and the same scaled about its middle and moved along x; with `turned`, that one
// is inward-oriented.
struct TwoBoxes {
  std::vector<double> positions;
  std::vector<std::uint32_t> corners;
  obc_surface surface{};

  TwoBoxes(double scale, double move, bool turned) {
    constexpr std::array<double, 3> middle = {1.5, 1, 1};
    const BoxSurface box;
    const std::size_t vertices = box.surface.vertex_count, triangles = box.surface.triangle_count;
    positions.assign(box.surface.positions, box.surface.positions + 3 * vertices);
    corners.assign(box.surface.triangles, box.surface.triangles + 3 * triangles);
    for (std::size_t i = 0; i < 3 * vertices; ++i)
      positions.push_back(middle[i % 3] + scale * (positions[i] - middle[i % 3]) + (i % 3 == 0 ? move : 0));
    for (std::size_t t = 0; t < triangles; ++t) {
      for (std::size_t k = 0; k < 3; ++k)
        corners.push_back(static_cast<std::uint32_t>(vertices) + corners[3 * t + (turned ? 2 - k : k)]);
    }
    surface = {positions.data(), 2 * vertices, corners.data(), 2 * triangles};
  }
};

}  // namespace orbicube::test
