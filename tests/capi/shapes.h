// Surfaces for the tests of the C interface.
#pragma once

#include <cstdint>
#include <vector>

#include "orbicube/mesh.h"

namespace orbicube::test {

struct Shape {
  std::vector<double> positions;
  std::vector<std::uint32_t> triangles;

  obc_surface surface() const {
    return {positions.data(), positions.size() / 3, triangles.data(), triangles.size() / 3};
  }
};

inline const Shape octahedron = {{1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1},
                                 {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}};

}  // namespace orbicube::test
