// What a surface must be to be the boundary of a solid that can be mapped, the pieces that a solid has and their
// cavities, and refusals that tell the place.
#pragma once

#include <cstdint>
#include <span>

#include "base/grouping.h"
#include "base/host.h"
#include "mesh/mesh.h"
#include "mesh/topology/place_text.h"

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
// (mesh/topology/topology.h), "cancelled".
void require_closed_surface(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                            const base::Host& host);

// Throws Error "self-intersection", likewise, where triangles of different connected parts meet, or more than a `share`
// of all triangles meet others where they should not. Returns how many pairs do.
std::size_t refuse_self_intersections(std::span<const mesh::Vector3> positions,
                                      std::span<const mesh::Triangle> triangles, double share, const base::Host& host);

// The connected parts of a surface.
Pieces surface_parts(std::span<const mesh::Triangle> triangles, std::size_t vertices, const base::Host& host);

// The solids that a closed surface bounds. What an odd number of its parts surrounds is solid: a part within another is
// the wall of a cavity of that, and a part within a cavity is a solid again.
struct SurfacePieces : Pieces {
  explicit SurfacePieces(std::pmr::memory_resource* memory) : Pieces(memory), wrong_side(memory) {}

  std::size_t cavities = 0;              // of all
  base::Array<std::uint8_t> wrong_side;  // 1 for each triangle that looks into its solid
};

// The parts must not meet, their triangles be turned to agree with their neighbors. O(n log n), and for each part
// within the box of another the triangles of that.
SurfacePieces surface_pieces(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                             const base::Host& host);

// Tetrahedra that are connected through faces. Throws Error "index-range".
Pieces pieces_of(std::span<const mesh::Tetrahedron> tetrahedra, std::size_t vertices, const base::Host& host);

// Throws Error "invalid-argument" where there are more pieces than cells: each needs at least one.
void require_cells_for_pieces(std::size_t pieces, std::size_t cells);

// The triangles or tetrahedra of each piece, in their order.
using PieceItems = base::Groups<mesh::Index>;
PieceItems items_of(const Pieces& pieces, const base::Host& host);

// Cuts a mesh into its pieces, each in time that grows with its own size. Keeps a reference to the mesh.
class PieceCutter {
 public:
  PieceCutter(const mesh::Mesh& mesh, const Pieces& pieces, const base::Host& host);

  // The mesh of one piece: its cells, or triangles, and the vertices that they have, in their order.
  mesh::Mesh piece(std::size_t which);

 private:
  const mesh::Mesh& mesh_;
  const base::Host& host_;
  PieceItems items_;
  base::Array<mesh::Index> number_;  // of vertices in the piece at hand
};

}  // namespace orbicube::volume_map
