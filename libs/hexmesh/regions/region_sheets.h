// Sheets of hexahedra along the faces between regions.
#pragma once

#include "hexmesh/regions/boundary_lines.h"
#include "hexmesh/regions/region_interfaces.h"

namespace orbicube::hexmesh {

// Sheets along the faces between labels, on the sides that require one. Where three regions meet, a quad between two of
// them may have two edges on the curve that will be straight: rings around the sheets of each two regions keep such
// quads off it.
Sheets add_sheets(HexMesh& mesh, Array<Index>& labels, const BoundaryLines& lines, RegionInterfaces& interfaces,
                  const base::Host& host);

}  // namespace orbicube::hexmesh
