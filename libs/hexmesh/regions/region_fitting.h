// The deformation that brings faces between hexahedra of different labels to those between the regions of a solid.
#pragma once

#include "hexmesh/certificate/hex_mesh.h"
#include "hexmesh/regions/boundary_lines.h"
#include "hexmesh/regions/region_interfaces.h"

namespace orbicube::hexmesh {

// Of a mesh with edges of about length 1 and sheets between the labels. Vertices move near the faces between labels:
// those of the boundary along the surface, of sharp lines along these, and others freely; `creases` as for
// RegionTargets. Returns whether every hexahedron is certainly positive.
bool fit_to_regions(HexMesh& mesh, const Array<Index>& labels, const Sheets& sheets, const BoundaryLines& lines,
                    RegionInterfaces& interfaces, bool creases, const base::Host& host);

}  // namespace orbicube::hexmesh
