// Hexahedra whose faces follow the faces between the regions of a solid.
#pragma once

#include "hexmesh/strategies/hex_draft.h"

namespace orbicube::hexmesh {

struct RegionFigures {
  Array<std::int32_t> of_hexahedra;  // the region of each
  bool conforming = false;           // faces between regions are on those of the solid, as far as `distance` says
  std::size_t lost = 0;              // regions that no hexahedron is in, thinner than these
  std::size_t interface_quads = 0;
  double distance = 0;  // two-sided, between the faces between regions of both, in percent of the diagonal
};

// Moves the faces between hexahedra of different regions onto those of the solid, after sheets of hexahedra along them
// where they are bent. The boundary may move along the surface there, sharp lines along themselves. The mesh stays as
// it is, each hexahedron with the region that most of it is in, where that has no valid result.
RegionFigures conform_to_regions(HexResult& result, const mesh::Mesh& solid, const base::Host& host);

}  // namespace orbicube::hexmesh
