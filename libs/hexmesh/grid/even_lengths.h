// The map of a surface with the planes of its polycube moved so that cells are about equally long in space everywhere:
// where the map stretches most, as over a protrusion on a flat face, there are more of them.
#pragma once

#include "hexmesh/types.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::hexmesh {

// Along each axis, what lies between two neighboring planes of the polycube becomes as long as it is in space, by the
// mean of the eighth powers of |d position / d polycube| over the map. A quarter of such an interval is moved by
// itself, or where triangles would fold, the whole, or nothing. The result is certified.
// O(n log n). Throws Error "cancelled".
polycube::SurfaceMap map_with_even_lengths(const polycube::SurfaceMap& map, const base::Host& host);

}  // namespace orbicube::hexmesh
