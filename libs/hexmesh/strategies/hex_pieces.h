// Hexahedral meshes of solids in several pieces.
#pragma once

#include "hexmesh/strategies/hex_meshing.h"

namespace orbicube::hexmesh {

// As make_hexahedra() of each piece, in one mesh. Pieces get their parts of the cells by their volumes; patches of the
// polycubes are numbered on. `options.distance` is of the whole solid: a piece may be off by so much of the diagonal of
// the whole, and by its share of the volume, so that specks do not drive the search. Quality, distance and error of
// the volume are those of the whole, and of each piece by itself (hex_figures.h). Throws Error as make_hexahedra(),
// with the piece and its place.
HexResult make_hexahedra_of_pieces(std::span<const PolycubeSurface> pieces, const HexOptions& options,
                                   const base::Host& host);

// Fills in distance, error of the volume and the one piece of a result of one piece.
void complete(HexResult& result, const PolycubeSurface& surface, const base::Host& host);

}  // namespace orbicube::hexmesh
