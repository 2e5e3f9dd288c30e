// Hexahedra from the cells of an integer domain: corners of cells taken back through the map of the surface.
#pragma once

#include "polycube/surface_map.h"
#include "volume_map/hex_mesh.h"
#include "volume_map/integer_domain.h"

namespace orbicube::volume_map {

// Vertices of the boundary are where the map's triangle says that has them by exact signs, those inside at the mean of
// their neighbours. The mesh is conforming by construction; hexahedra need not be positive. Throws Error
// "no-valid-result" when a point is in no triangle, "cancelled". O(n) but for the searches.
HexMesh sample_hexahedra(const IntegerDomain& domain, const polycube::SurfaceMap& surface, const base::Host& host);

}  // namespace orbicube::volume_map
