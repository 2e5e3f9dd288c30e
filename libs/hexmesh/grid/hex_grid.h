// Hexahedra from the cells of a grid, and from those of an integer domain: corners of cells taken back through the map
// of the surface.
#pragma once

#include "hexmesh/certificate/hex_mesh.h"
#include "hexmesh/grid/integer_domain.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::hexmesh {

// The cells of a grid that are inside, entry (x size[1] + y) size[2] + z, as hexahedra with their corners at integers.
// Quads lie on no patch of a polycube yet: all on 0.
HexMesh hexahedra_of_cells(const std::array<int, 3>& size, std::span<const std::uint8_t> inside,
                           const base::Host& host);

// Vertices of the boundary are where the map's triangle says that has them by exact signs, those inside at the mean of
// their neighbors. The mesh is conforming by construction; hexahedra need not be positive. Throws Error
// "no-valid-result" when a point is in no triangle, "cancelled". O(n) but for the searches.
HexMesh sample_hexahedra(const IntegerDomain& domain, const polycube::SurfaceMap& surface, const base::Host& host);

}  // namespace orbicube::hexmesh
