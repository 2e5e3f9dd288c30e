// How much of a feature graph the boundary of a mesh reproduces, whatever made the mesh.
#pragma once

#include "hexmesh/captured/feature_surface.h"
#include "hexmesh/certificate/hex_mesh.h"

namespace orbicube::hexmesh {

// Of each curve the fraction of its length with a boundary edge of the mesh that runs within a tenth of the mean
// boundary edge, and turns no more than 25 degrees away from it; of each corner that is not soft whether a boundary
// vertex is as near. Curves of which less than 95 percent is captured are missing. Sets curves, corners, captured,
// and missing. O(n log n).
void measure_captured(const HexMesh& mesh, const FeatureSurface& surface, FeatureFigures& figures,
                      const base::Host& host);

}  // namespace orbicube::hexmesh
