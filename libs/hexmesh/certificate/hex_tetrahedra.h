// The tetrahedra that measure the quality of a hexahedron: one at each of its corners, of the corner's three edges, and
// two along each edge, of the edge, one more from its beginning and the third from its end. The determinant of the
// trilinear map is positive at the corners where the first eight are; its coefficients on edges are means of two of the
// others, those on faces and inside of more such products of edges. So hexahedra with good corners that are twisted are
// seen by the others.
#pragma once

#include <cmath>

#include "hexmesh/certificate/hex_mesh.h"
#include "untangle/tetrahedra/elements.h"

namespace orbicube::hexmesh {

using untangle::Element;

inline constexpr std::size_t corner_tetrahedra = 8, edge_tetrahedra = 24;

// The direction of each corner's three edges.
inline constexpr std::array<std::array<std::uint8_t, 3>, 8> direction_of_edge = {
    {{0, 1, 2}, {1, 0, 2}, {0, 1, 2}, {1, 0, 2}, {1, 0, 2}, {0, 1, 2}, {1, 0, 2}, {0, 1, 2}}};

// One of them: its vertices, and for each of the three directions of the box, positively oriented, which of the box's
// lengths it has and the edge that runs along it.
struct HexTetrahedron {
  std::array<std::uint8_t, 4> vertices{};
  std::array<std::uint8_t, 3> direction{};
  std::array<std::array<std::uint8_t, 2>, 3> edge{};  // of vertices, from and to

  Element element(const Hexahedron& h) const {
    return {.corner = {h[vertices[0]], h[vertices[1]], h[vertices[2]], h[vertices[3]]}, .gradient = {}, .weight = 1};
  }
  // That of a box with these lengths is the target shape.
  void set_shape(const std::array<double, 3>& lengths, Element& element) const {
    element.gradient.fill(Vector3::Zero());
    for (std::size_t d = 0; d < 3; ++d) {
      const auto axis = static_cast<Eigen::Index>(d);
      element.gradient[edge[d][0]][axis] -= 1 / lengths[direction[d]];
      element.gradient[edge[d][1]][axis] += 1 / lengths[direction[d]];
    }
  }
  // The determinant of its three edges over the product of their lengths; 1 for a box.
  double scaled_jacobian(std::span<const Vector3> positions, const Element& element) const {
    std::array<Vector3, 3> along;
    for (std::size_t d = 0; d < 3; ++d)
      along[d] = positions[element.corner[edge[d][1]]] - positions[element.corner[edge[d][0]]];
    const double lengths = std::sqrt(along[0].squaredNorm() * along[1].squaredNorm() * along[2].squaredNorm());
    return lengths > 0 ? along[0].dot(along[1].cross(along[2])) / lengths : 0;
  }
};

// Those at the corners, in the order of the corners, and then those along edges.
inline constexpr auto hex_tetrahedra = [] {
  std::array<HexTetrahedron, corner_tetrahedra + edge_tetrahedra> all{};
  std::size_t next = corner_tetrahedra;
  for (std::uint8_t a = 0; a < 8; ++a) {
    const auto& neighbors = corner_neighbors[a];
    const auto& direction = direction_of_edge[a];
    all[a] = {{a, neighbors[0], neighbors[1], neighbors[2]}, direction, {{{0, 1}, {0, 2}, {0, 3}}}};
    for (std::size_t j = 0; j < 3; ++j) {
      const std::uint8_t b = neighbors[j];
      if (b < a) continue;
      // Of the edge from a to b and what follows it, positively oriented, one from a and one from b.
      const std::size_t k = (j + 1) % 3, l = (j + 2) % 3;
      const auto from_b = [&](std::uint8_t along) {
        std::size_t i = 0;
        while (direction_of_edge[b][i] != along)
          ++i;
        return corner_neighbors[b][i];
      };
      const std::array<std::uint8_t, 3> turned = {direction[j], direction[k], direction[l]};
      all[next++] = {{a, b, neighbors[k], from_b(direction[l])}, turned, {{{0, 1}, {0, 2}, {1, 3}}}};
      all[next++] = {{a, b, from_b(direction[k]), neighbors[l]}, turned, {{{0, 1}, {1, 2}, {0, 3}}}};
    }
  }
  return all;
}();

}  // namespace orbicube::hexmesh
