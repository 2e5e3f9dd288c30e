// Sheets of hexahedra between the parts of a mesh (Mitchell and Tautges 1995, "Pillowing doublets").
#pragma once

#include <functional>

#include "hexmesh/certificate/hex_mesh.h"

namespace orbicube::hexmesh {

// Puts a hexahedron on every face between hexahedra of different labels, on each side whose label is not 0. Faces on
// the boundary stay, so that sheets come out there as rings of quads along the borders of the labels. A vertex gets
// one copy for each fan of equal labels. New hexahedra have the label of their side and are the last. The quads of the
// mesh are not brought up to date. O(n) for the search of labels, then O(hexahedra with a label).
void pillow(HexMesh& mesh, Array<Index>& labels, const base::Host& host);

// The same, also on the faces of the boundary that is_covered(hexahedron, quad) says of.
using IsCovered = std::function<bool(Index, const Quad&)>;
void pillow(HexMesh& mesh, Array<Index>& labels, const IsCovered& is_covered, const base::Host& host);

// The same for one hexahedron of the boundary: each boundary vertex of it gains an edge.
void pillow_one(HexMesh& mesh, Index hexahedron, const base::Host& host);

}  // namespace orbicube::hexmesh
