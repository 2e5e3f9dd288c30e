// Polycubes made of unit cubes, for tests: the boundary of a set of cells, each square cut into two triangles.
#pragma once

#include <doctest/doctest.h>

#include <array>
#include <map>
#include <vector>

#include "mesh/mesh.h"
#include "polycube/map/certificate.h"
#include "polycube/surface/surface.h"

namespace orbicube::test {

using Cell = std::array<int, 3>;

inline mesh::Mesh blocks(const std::vector<Cell>& cells) {
  mesh::Mesh result;
  std::map<Cell, mesh::Index> vertices;
  const auto vertex = [&](const Cell& at) {
    const auto [place, is_new] = vertices.emplace(at, static_cast<mesh::Index>(result.positions.size()));
    if (is_new) result.positions.emplace_back(at[0], at[1], at[2]);
    return place->second;
  };
  const auto filled = [&](const Cell& c) {
    for (const Cell& other : cells) {
      if (other == c) return true;
    }
    return false;
  };
  for (const Cell& cell : cells) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        Cell beside = cell;
        beside[axis] += side == 1 ? 1 : -1;
        if (filled(beside)) continue;
        std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        if (side == 0) std::swap(u, v);
        Cell at = cell;
        at[axis] += side;
        std::array<mesh::Index, 4> square{};
        square[0] = vertex(at);
        ++at[u];
        square[1] = vertex(at);
        ++at[v];
        square[2] = vertex(at);
        --at[u];
        square[3] = vertex(at);
        result.triangles.push_back({square[0], square[1], square[2]});
        result.triangles.push_back({square[0], square[2], square[3]});
      }
    }
  }
  return result;
}

inline polycube::Surface surface_of(const mesh::Mesh& m, const base::Host& host) {
  return {base::Array<mesh::Vector3>(m.positions), base::Array<mesh::Triangle>(m.triangles), host};
}

// Cells in a box from the origin, without some.
inline std::vector<Cell> box_without(const Cell& size, const std::vector<Cell>& without = {}) {
  std::vector<Cell> result;
  for (int x = 0; x < size[0]; ++x) {
    for (int y = 0; y < size[1]; ++y) {
      for (int z = 0; z < size[2]; ++z) {
        bool left_out = false;
        for (const Cell& cell : without)
          left_out = left_out || cell == Cell{x, y, z};
        if (!left_out) result.push_back({x, y, z});
      }
    }
  }
  return result;
}

// The map of a polycube to itself, an isometry.
inline polycube::SurfaceMap on_itself(const mesh::Mesh& surface, const base::Host& host) {
  polycube::SurfaceMap map;
  map.positions = map.polycube = surface.positions;
  map.triangles = surface.triangles;
  set_unrefined(map);
  REQUIRE(certify(map, host).valid());
  return map;
}

}  // namespace orbicube::test
