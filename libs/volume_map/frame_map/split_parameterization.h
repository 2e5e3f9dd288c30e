// Parameterizations of solids whose tetrahedra are split first where the constraints leave them no room.
#pragma once

#include "volume_map/frame_map/parameterization.h"

namespace orbicube::volume_map {

// Splits the solid as split_for_frames() does: a tetrahedron with two faces in one plane of the boundary, or with an
// edge between points of one singular curve, has no volume in any map. Then splits around the tetrahedra that are
// inverted. Goes on, in rounds, while each leaves fewer inverted tetrahedra than the one before, and returns the map
// with the fewest; `solid` is the one that it is of. Nothing is untangled: what stays inverted is counted. Throws what
// parameterize() does.
Parameterization parameterize_split(FramedSolid& solid, const ParameterizationOptions& options, const base::Host& host);

}  // namespace orbicube::volume_map
