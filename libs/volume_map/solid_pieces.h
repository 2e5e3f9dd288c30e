// What a surface must be to be the boundary of a solid that can be mapped, the pieces that a solid has, and refusals
// that tell the place.
#pragma once

#include <span>
#include <string>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::volume_map {

// For each triangle or tetrahedron the piece that it belongs to, numbered in the order of their first ones.
struct Pieces {
  explicit Pieces(std::pmr::memory_resource* memory) : of(memory) {}

  base::Array<mesh::Index> of;
  std::size_t count = 0;
};

// "(x, y, z)", to nine digits.
std::string place_text(const mesh::Vector3& p);

// The connected parts of a surface that bounds a solid, of one piece each. Throws Error, with how many, the numbers and
// the coordinates of the first place: "degenerate-face", "duplicate-face", "non-manifold-edge", "not-closed",
// "non-manifold-vertex", "non-orientable", "self-intersection" and, of parts within each other, "not-connected": a
// cavity, which no polycube map has. Also "empty-mesh", "degenerate-geometry", "invalid-argument" (mesh/topology.h),
// "cancelled". Triangles must be turned to agree with their neighbours, inward or outward.
Pieces require_solid_surface(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                             const base::Host& host);

// Tetrahedra that are connected through faces. Throws Error "index-range".
Pieces pieces_of(std::span<const mesh::Tetrahedron> tetrahedra, std::size_t vertices, const base::Host& host);

// Throws Error "not-connected" where parts of a closed, oriented surface that bounds connected tetrahedra are cavities;
// `surface` looks outward, so that these look inward, with the coordinates of one.
void refuse_cavities(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> surface,
                     const base::Host& host);

// A mesh of one piece: its cells, or triangles, and the vertices that they have, in their order.
mesh::Mesh piece(const mesh::Mesh& mesh, const Pieces& pieces, std::size_t which, const base::Host& host);

}  // namespace orbicube::volume_map
