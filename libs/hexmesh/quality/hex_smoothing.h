// Hexahedra made better: first until the eight tetrahedra at the corners of each are positive, then towards right
// angles, with the boundary on the surface and the surface on the boundary.
#pragma once

#include "hexmesh/quality/hex_boundary.h"

namespace orbicube::hexmesh {

struct HexSmoothingOptions {
  int untangling_steps = 80;
  int rounds = 40;          // of two steps each, all corners positive
  bool lift = true;         // vertices of the boundary, so that the volume is that of the surface
  std::size_t padding = 0;  // number of the last hexahedra are the layer at the boundary
  // Where the surface is farther than this from the boundary, or the boundary from it, the boundary is fixed the more
  // to where it began; 0: nowhere.
  double distance = 0;
  double max_weight =
      60;  // of a corner that stays bad: a larger one untangles some, and spoils the neighbors of others
};

// Lengths of cells are about 1. Returns whether all corners are positive, in floating point. Vertices end near the
// surface, not on it (hex_search.h). The same for any number of threads. Throws Error "cancelled".
bool smooth_hexahedra(HexMesh& mesh, HexBoundary& boundary, const SurfaceTarget& target,
                      const HexSmoothingOptions& options, const base::Host& host);

}  // namespace orbicube::hexmesh
