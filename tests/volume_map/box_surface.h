// A surface of boxes and single triangles, to be measured or refused.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "volume_map/types.h"

namespace orbicube::volume_map::test {

struct BoxSurface {
  std::vector<Vector3> positions;
  std::vector<mesh::Triangle> triangles;

  void add_triangle(const Vector3& a, const Vector3& b, const Vector3& c) {
    const auto first = static_cast<Index>(positions.size());
    positions.insert(positions.end(), {a, b, c});
    triangles.push_back({first, first + 1, first + 2});
  }

  // An outward-oriented box, or an inward-oriented one.
  void add_box(const Vector3& low, const Vector3& size, bool inward = false) {
    const auto first = static_cast<Index>(positions.size());
    for (int i = 0; i < 8; ++i)
      positions.push_back(low + size.cwiseProduct(Vector3(i & 1, i >> 1 & 1, i >> 2)));
    constexpr mesh::Triangle faces[] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                        {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    for (mesh::Triangle t : faces) {
      for (Index& v : t)
        v += first;
      if (inward) std::swap(t[1], t[2]);
      triangles.push_back(t);
    }
  }
};

}  // namespace orbicube::volume_map::test
