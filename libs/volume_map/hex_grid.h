// Hexahedra from the cells of an integer domain: corners of cells taken back through the map of the solid.
#pragma once

#include "polycube/surface_map.h"
#include "volume_map/hex_mesh.h"
#include "volume_map/integer_domain.h"
#include "volume_map/solid_map.h"

namespace orbicube::volume_map {

// Vertices inside are where the tetrahedron that has them says, those of the boundary where the triangle says that has
// them by exact signs. `surface` is the map whose vertices come first in the solid. The mesh is conforming by
// construction; hexahedra need not be positive. Throws Error "no-valid-result" when a point is in no triangle,
// "cancelled". O(n) but for the search.
HexMesh sample_hexahedra(const IntegerDomain& domain, const SolidMap& solid, const polycube::SurfaceMap& surface,
                         const base::Host& host);

// A layer of hexahedra between the boundary and the rest: what was the boundary moves inwards by a quarter of
// `cell_length`.
void pad(HexMesh& mesh, double cell_length, const base::Host& host);

}  // namespace orbicube::volume_map
