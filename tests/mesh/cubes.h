// Solids of cubes, each cut into six tetrahedra.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "mesh/mesh.h"
#include "mesh/search/predicates.h"

namespace orbicube::test {

using mesh::Index;
using mesh::Tetrahedron;
using mesh::Vector3;

struct Solid {
  std::vector<Vector3> positions;
  std::vector<Tetrahedron> tetrahedra;

  // Makes all tetrahedra positive.
  void orient() {
    for (Tetrahedron& t : tetrahedra) {
      if (mesh::orientation_3d(positions[t[0]], positions[t[1]], positions[t[2]], positions[t[3]]) < 0)
        std::swap(t[2], t[3]);
    }
  }
};

// Cubes counted along three axes, each cut into six tetrahedra about its diagonal, which match across the cubes' faces;
// with `ring`, the last cube along the first axis is followed by the first.
inline Solid cubes(Index m, Index n, Index o, bool ring = false) {
  Solid solid;
  const Index layers = ring ? m : m + 1;
  const auto at = [&](Index i, Index j, Index k) { return (i % layers * (n + 1) + j) * (o + 1) + k; };
  for (Index i = 0; i < layers; ++i) {
    for (Index j = 0; j <= n; ++j) {
      for (Index k = 0; k <= o; ++k)
        solid.positions.emplace_back(i, j, k);
    }
  }
  for (Index cube = 0; cube < m * n * o; ++cube) {
    const std::array<Index, 3> corner{cube / (n * o), cube / o % n, cube % o};
    std::array<std::size_t, 3> order{0, 1, 2};
    do {
      std::array<Index, 3> p = corner;
      Tetrahedron t{};
      t[0] = at(p[0], p[1], p[2]);
      for (std::size_t k = 0; k < 3; ++k) {
        ++p[order[k]];
        t[k + 1] = at(p[0], p[1], p[2]);
      }
      solid.tetrahedra.push_back(t);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  if (!ring) solid.orient();
  return solid;
}

}  // namespace orbicube::test
