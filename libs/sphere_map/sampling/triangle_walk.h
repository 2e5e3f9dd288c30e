// From a triangle of the sphere to the one that has a direction, through neighbors, each turn by an exact sign
// (Devillers, Pion and Teillaud, Walking in a triangulation, 2002: the remembering stochastic walk).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "mesh/mesh.h"

namespace orbicube::sphere_map {

// A triangle that has a direction, and on which of its edges (bit k: the one from corner k) that lies: on two of them
// is on the corner between.
struct WalkEnd {
  mesh::Index triangle;
  unsigned on_edges;

  // The corner that the direction is at; 3 when it is at none.
  unsigned corner() const {
    switch (on_edges) {
      case 3:
        return 1;
      case 6:
        return 2;
      case 5:
        return 0;
      default:
        return 3;
    }
  }
};

// side(half_edge) is the sign of where the direction lies, positive inside of the half-edge's triangle;
// opposite(half_edge) the other one on its edge. Nothing is returned when the walk was longer than `longest`.
template <class Side, class Opposite>
std::optional<WalkEnd> walk_to(mesh::Index start, std::size_t longest, const Side& side, const Opposite& opposite) {
  using mesh::Index;
  Index triangle = start;
  Index entered = mesh::no_index;  // by this half-edge, which has the direction strictly inside
  std::uint32_t random = 0x9e3779b9U;
  for (std::size_t step = 0; step < longest; ++step) {
    random = random * 1664525U + 1013904223U;
    Index k = (random >> 16U) % 3;
    unsigned on_edges = 0;
    Index leaves_by = mesh::no_index;
    for (int i = 0; i < 3; ++i, k = k == 2 ? 0 : k + 1) {
      const Index half_edge = 3 * triangle + k;
      if (half_edge == entered) continue;
      const int where = side(half_edge);
      if (where < 0) {
        leaves_by = half_edge;
        break;
      }
      on_edges |= static_cast<unsigned>(where == 0) << k;
    }
    if (leaves_by == mesh::no_index) return WalkEnd{triangle, on_edges};
    entered = opposite(leaves_by);
    triangle = entered / 3;
  }
  return std::nullopt;
}

// The same by looking at each of `count` triangles.
template <class Side>
std::optional<WalkEnd> scan_for(std::size_t count, const Side& side) {
  for (mesh::Index triangle = 0; triangle < count; ++triangle) {
    unsigned on_edges = 0;
    bool inside = true;
    for (mesh::Index k = 0; k < 3 && inside; ++k) {
      const int where = side(3 * triangle + k);
      inside = where >= 0;
      on_edges |= static_cast<unsigned>(where == 0) << k;
    }
    if (inside) return WalkEnd{triangle, on_edges};
  }
  return std::nullopt;
}

}  // namespace orbicube::sphere_map
