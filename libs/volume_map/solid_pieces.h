// What a surface must be to be the boundary of a solid that can be mapped, the pieces that a solid has, and refusals
// that tell the place.
#pragma once

#include <span>
#include <string>

#include "base/host.h"
#include "mesh/mesh.h"
#include "mesh/place_text.h"

namespace orbicube::volume_map {

// For each triangle or tetrahedron the piece that it belongs to, numbered in the order of their first ones.
struct Pieces {
  explicit Pieces(std::pmr::memory_resource* memory) : of(memory) {}

  base::Array<mesh::Index> of;
  std::size_t count = 0;
};

using mesh::place_text;

// Throws Error unless the triangles are closed manifold surfaces with two sides and area, with how many, the numbers
// and the coordinates of the first place: "degenerate-face", "duplicate-face", "non-manifold-edge", "not-closed",
// "non-manifold-vertex", "non-orientable". Also "empty-mesh", "degenerate-geometry", "invalid-argument"
// (mesh/topology.h), "cancelled".
void require_closed_surface(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                            const base::Host& host);

// Throws Error "self-intersection", likewise, where more than a `part` of the triangles meet others where they should
// not. Answers how many pairs do.
std::size_t refuse_self_intersections(std::span<const mesh::Vector3> positions,
                                      std::span<const mesh::Triangle> triangles, double part, const base::Host& host);

// The connected parts of a closed surface, each the boundary of one piece. Triangles must be turned to agree with their
// neighbours, inward or outward. Throws Error "not-connected" where parts lie within each other: a cavity, which no map
// to a polycube has.
Pieces surface_pieces(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                      const base::Host& host);

// Tetrahedra that are connected through faces. Throws Error "index-range".
Pieces pieces_of(std::span<const mesh::Tetrahedron> tetrahedra, std::size_t vertices, const base::Host& host);

// Throws Error unless tetrahedra meet in whole faces, two at each, on its two sides when both are positive:
// "index-range", "non-manifold-face", "inconsistent-orientation", with the numbers of the first place and its
// coordinates; "cancelled". Inverted ones are fine. O(n log n).
void require_conforming(std::span<const mesh::Tetrahedron> tetrahedra, std::span<const mesh::Vector3> positions,
                        const base::Host& host);

// Throws Error "not-connected" where parts of a closed, oriented surface that bounds connected tetrahedra are cavities;
// `surface` looks outward, so that these look inward, with the coordinates of one.
void refuse_cavities(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> surface,
                     const base::Host& host);

// A mesh of one piece: its cells, or triangles, and the vertices that they have, in their order.
mesh::Mesh piece(const mesh::Mesh& mesh, const Pieces& pieces, std::size_t which, const base::Host& host);

}  // namespace orbicube::volume_map
