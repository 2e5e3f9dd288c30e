// Tips and ridges of the surface that the boundary of a mesh of hexahedra is too far from.
#pragma once

#include "hexmesh/quality/hex_boundary.h"

namespace orbicube::hexmesh {

// Points of the surface that are farther than `distance` from the boundary, or nearly so, get it nearer: the vertices
// of the quad that is nearest to each are tried at places on the surface that are nearer to all such points they stand
// for, and vertices inside make room. No hexahedron gets worse than 0.5 for it, or than the worst of those around it
// was; where that does not do, 0.3, then 0.15 (hex_moves.h). Lengths of cells are about 1. The same in every run.
// Throws Error "cancelled".
void reach_surface(HexMesh& mesh, const HexBoundary& boundary, const SurfaceTarget& target, double distance,
                   const base::Host& host);

}  // namespace orbicube::hexmesh
