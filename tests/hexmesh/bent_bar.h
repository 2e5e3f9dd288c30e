// A bar of hexahedra that is bent, for the tests of what lies over itself.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hexmesh/grid/hex_grid.h"
#include "hexmesh/strategies/hex_draft.h"

namespace orbicube::hexmesh::test {

// n x width x width cells, bent around the z axis by an angle in all, from radius 2 to 3.
inline HexMesh bent_bar(int n, int width, double angle, const base::Host& host) {
  const std::array<int, 3> size = {n, width, width};
  const std::vector<std::uint8_t> inside(static_cast<std::size_t>(n * width * width), 1);
  HexMesh mesh = hexahedra_of_cells(size, inside, host);
  for (Vector3& p : mesh.positions) {
    const double a = -angle * p[0] / n, r = 2 + p[1] / width;
    p = {-r * std::sin(a), r * std::cos(a), p[2] / width};
  }
  return mesh;
}

}  // namespace orbicube::hexmesh::test
