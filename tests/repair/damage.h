// Surfaces, and ways to damage them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/random.h"
#include "mesh/mesh.h"
#include "mesh/shapes/make_shape.h"
#include "mesh/topology/edge_table.h"
#include "repair/repair.h"

namespace orbicube::test {

using mesh::Index;
using mesh::Mesh;
using mesh::Triangle;
using mesh::Vector3;

// A cube of two triangles a side, outward-oriented.
inline Mesh cube(const Vector3& low = Vector3::Zero(), double size = 1) {
  Mesh m;
  for (int v = 0; v < 8; ++v)
    m.positions.push_back(low + size * Vector3(v & 1, (v >> 1) & 1, v >> 2));
  m.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                 {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return m;
}

// Both, the second with vertices of its own.
inline Mesh together(const Mesh& a, const Mesh& b) {
  Mesh m = a;
  const auto shift = static_cast<Index>(a.positions.size());
  m.positions.insert(m.positions.end(), b.positions.begin(), b.positions.end());
  for (const Triangle& t : b.triangles)
    m.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return m;
}

// Vertices at one position become one, whatever that joins.
inline void weld_all(Mesh& m) {
  for (std::size_t v = 0; v < m.positions.size(); ++v) {
    for (std::size_t w = 0; w < v; ++w) {
      if (m.positions[w] != m.positions[v]) continue;
      for (Triangle& t : m.triangles) {
        for (Index& c : t)
          c = c == v ? static_cast<Index>(w) : c;
      }
      break;
    }
  }
}

inline repair::Repaired repaired(const Mesh& m, const repair::Options& options = {}) {
  return repair::repair(m.positions, m.triangles, options, base::Host());
}

// Removes the triangles around `count` vertices.
inline void add_holes(Mesh& m, std::size_t count, base::Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto v = static_cast<Index>(random.below(m.positions.size()));
    std::erase_if(m.triangles, [&](const Triangle& t) { return t[0] == v || t[1] == v || t[2] == v; });
  }
}

inline void flip_some(Mesh& m, std::size_t count, base::Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    Triangle& t = m.triangles[random.below(m.triangles.size())];
    std::swap(t[1], t[2]);
  }
}

inline void add_specks(Mesh& m, std::size_t count, base::Random& random) {
  for (std::size_t i = 0; i < count; ++i)
    m = together(m, cube(Vector3(3 + random.unit(), 3 * random.unit(), static_cast<double>(i)), 0.01));
}

// Corners of triangles get vertices of their own, at the same position or moved by `noise`.
inline void tear(Mesh& m, std::size_t count, double noise, base::Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    Index& corner = m.triangles[random.below(m.triangles.size())][random.below(3)];
    const Vector3 moved = m.positions[corner] + noise * Vector3(random.unit(), random.unit(), random.unit());
    corner = static_cast<Index>(m.positions.size());
    m.positions.push_back(moved);
  }
}

// Splits triangles at the middle of an edge, without their neighbor.
inline void add_t_junctions(Mesh& m, std::size_t count, base::Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = random.below(m.triangles.size());
    const Triangle t = m.triangles[at];
    const auto v = static_cast<Index>(m.positions.size());
    m.positions.push_back(0.5 * (m.positions[t[0]] + m.positions[t[1]]));
    m.triangles[at] = {t[0], v, t[2]};
    m.triangles.push_back({v, t[1], t[2]});
  }
}

// Splits triangles at a point next to a vertex (needles) or to an edge (caps), at the height over their size.
inline void add_slivers(Mesh& m, std::size_t count, double height, base::Random& random) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = random.below(m.triangles.size());
    const Triangle t = m.triangles[at];
    const double along = i % 2 == 0 ? height : 0.5;
    const Vector3 weights(1 - along - height, along, height);
    const auto v = static_cast<Index>(m.positions.size());
    m.positions.push_back(weights[0] * m.positions[t[0]] + weights[1] * m.positions[t[1]] +
                          weights[2] * m.positions[t[2]]);
    m.triangles[at] = {t[0], t[1], v};
    m.triangles.push_back({t[1], t[2], v});
    m.triangles.push_back({t[2], t[0], v});
  }
}

}  // namespace orbicube::test
