// Edges of a labeled surface split, with a record of where each new vertex comes from.
#pragma once

#include <span>

#include "base/host.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

// A map of the surface as it is, with labels and without positions on the polycube.
SurfaceMap unrefined(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                     std::span<const AxisLabel> labels, const base::Host& host);

// Splits, at their middle, all edges inside a patch whose ends are both on boundaries of patches: such an edge could
// collapse on the polycube, where both ends may lie on one line. Patch numbers are not kept up.
void split_chords(SurfaceMap& map, const base::Host& host);

}  // namespace orbicube::polycube
