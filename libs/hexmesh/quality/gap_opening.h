// Meshes of hexahedra whose boundary meets itself across a narrow gap, where flat quads cut corners of curved walls or
// smoothing moved both walls too far: the walls are moved apart by as little as it takes.
#pragma once

#include "hexmesh/certificate/hex_mesh.h"

namespace orbicube::hexmesh {

// Moves corners of boundary quads that intersect away from each other, against their normals, until no two quads
// intersect. No hexahedron around a corner that moves gets worse than a scaled Jacobian of 0.1, or than it was.
// Returns whether nothing intersects any more; where something still does, positions are left as far as that went.
// The same in every run, for any number of threads. Throws Error "cancelled".
bool open_gaps(HexMesh& mesh, const base::Host& host);

}  // namespace orbicube::hexmesh
