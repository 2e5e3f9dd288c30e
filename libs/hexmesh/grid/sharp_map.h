// The map of a surface whose sharp edges lie on edges of its polycube: hexahedra follow them there.
#pragma once

#include <optional>

#include "hexmesh/types.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::hexmesh {

// A map to the same polycube, certified, in which what bends by `degrees` or more lies on edges nearby
// (polycube/features/features.h). Nothing where that is less than a fifth of the polycube's edges or three fifths of
// what bends so much, or there is no such map. Throws Error "cancelled".
std::optional<polycube::SurfaceMap> map_with_sharp_edges(const polycube::SurfaceMap& map, double degrees,
                                                         const base::Host& host);

}  // namespace orbicube::hexmesh
