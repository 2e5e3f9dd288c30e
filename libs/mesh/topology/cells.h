// Whether the tetrahedra and hexahedra of a mesh are those of a solid: positive, distinct, and meeting in whole faces.
#pragma once

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// The corners of each face of a hexahedron, counter-clockwise seen from outside.
inline constexpr std::array<std::array<std::size_t, 4>, 6> hexahedron_faces = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

// Throws Error unless the cells fill a solid, with the number of such places and the first of them:
// - "index-range": a vertex that does not exist;
// - "degenerate-cell": a repeated vertex, a tetrahedron of volume 0, a hexahedron with a corner whose three edges lie
//   in a plane;
// - "inverted-cell": a tetrahedron of negative volume, a hexahedron with an inverted corner (its Jacobian
//   there is negative). Signs are exact;
// - "duplicate-cell": two cells of the same vertices;
// - "non-manifold-face": a face of three cells or more, or a face of a hexahedron that triangles of tetrahedra lie on,
//   but not two that fill it;
// - "non-manifold-edge": an edge of the solid's boundary with more than two boundary faces.
// Also "cancelled". A mesh without cells is fine. O(n log n) time, O(n) for bounded valence; 80 bytes a tetrahedron and
// 150 a hexahedron while it runs.
void require_valid_cells(const Mesh& mesh, const base::Host& host);

// The surface of the solid that the cells fill, outward-oriented: the faces of one cell only, those of hexahedra cut
// along their shorter diagonal. A face of a hexahedron that two triangles of tetrahedra fill lies inside. Vertices keep
// their numbers. Throws Error "index-range", "non-manifold-face", "cancelled". O(n log n).
Array<Triangle> boundary_triangles(const Mesh& mesh, const base::Host& host);

// The faces of hexahedra that one cell only has, outward-oriented, each from the vertex that the order of MEDIT and VTK
// gives to it first. Throws as boundary_triangles.
Array<std::array<Index, 4>> boundary_quads(const Mesh& mesh, const base::Host& host);

struct CellTurnReport {
  std::size_t tetrahedra = 0;  // that were turned: all or none
  std::size_t hexahedra = 0;
};

// Turns all tetrahedra if none is positive and one at least is inverted, and likewise all hexahedra, where more corners
// count than not: other programs count the vertices of a cell the other way round. Throws Error "index-range",
// "cancelled". O(n).
CellTurnReport turn_inverted_cells(Mesh& mesh, const base::Host& host);

}  // namespace orbicube::mesh
