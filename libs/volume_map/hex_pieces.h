// Hexahedral meshes of solids in several pieces.
#pragma once

#include "volume_map/hex_meshing.h"

namespace orbicube::volume_map {

// As make_hexahedra() of each piece, in one mesh. Pieces get their parts of the cells by their volumes; faces of the
// polycubes are numbered on. The quality is that of all; the distance and the error of the volume are the largest, each
// in percent of its own piece. What fails is said with the number of the piece.
HexResult make_hexahedra_of_pieces(std::span<const PolycubeSurface> pieces, const HexOptions& options,
                                   const base::Host& host);

}  // namespace orbicube::volume_map
