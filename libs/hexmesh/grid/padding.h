// Layers of hexahedra between patches of the polycube and the rest of the mesh. Where an edge of the polycube is round
// in space, a layer gives the hexahedra there room for right angles; where it is sharp, a layer takes them away. After
// Cherchi, Alliez, Scateni, Lyon and Bommes (2019), Selective padding for polycube-based hexahedral meshing.
#pragma once

#include "hexmesh/certificate/hex_mesh.h"

namespace orbicube::hexmesh {

// Of each patch of the polycube whether a layer is to lie on it: what makes the angles of the hexahedra along the edges
// of the polycube, as they are in space, differ least from right ones. Faces that meet at an edge turned inwards, or
// without an edge, are padded together; those around a vertex lie beside each other. O(n log n) and a local search over
// the faces. Throws Error "cancelled".
Array<std::uint8_t> choose_padding(const HexMesh& mesh, const base::Host& host);

// Puts the layers on: what was the boundary there moves inwards by a quarter of `cell_length`. Beside the border of
// what is padded the layer's sides belong to the patch of the polycube that they prolong. New hexahedra are the last.
void pad(HexMesh& mesh, std::span<const std::uint8_t> padded, double cell_length, const base::Host& host);

}  // namespace orbicube::hexmesh
