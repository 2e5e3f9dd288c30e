// Closed surfaces of genus 0 for the tests of sphere_map.
#pragma once

#include <cmath>
#include <map>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "mesh/mesh.h"
#include "sphere_map/optimization/measure.h"

namespace orbicube::test {

using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

struct Surface {
  std::vector<Vector3> positions;
  std::vector<Triangle> triangles;
};

// With the default weights of angles and areas.
inline sphere_map::Measurement measured(const Surface& s, std::span<const Vector3> directions,
                                        sphere_map::FaceDistortion* faces = nullptr) {
  return sphere_map::measure(s.positions, s.triangles, directions, 0.1, 1, base::Host(), faces);
}

inline Surface tetrahedron() {
  return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

// An octahedron with each triangle split in four `levels` times, its vertices on the unit sphere.
inline Surface sphere(int levels) {
  Surface s{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [entry, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<Index>(s.positions.size()));
      if (is_new) s.positions.push_back((s.positions[a] + s.positions[b]).normalized());
      return entry->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const Index ab = middle(a, b);
      const Index bc = middle(b, c);
      const Index ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    s.triangles = std::move(finer);
  }
  return s;
}

// A sphere with long arms in the directions of a cube's corners and a dent, no symmetry left.
inline Surface creature(int levels) {
  Surface s = sphere(levels);
  for (Vector3& p : s.positions) {
    const Vector3 direction = p;
    double radius = 0.7 + 0.2 * direction.x();
    for (int corner = 0; corner < 8; corner += 2) {
      const Vector3 axis = Vector3(corner & 1 ? 1 : -1, corner & 2 ? 1 : -0.8, corner & 4 ? 1.2 : -1).normalized();
      radius += (1.5 + 0.4 * corner) * std::exp(-30 * (1 - axis.dot(direction)));
    }
    p = radius * direction;
  }
  return s;
}

}  // namespace orbicube::test
