// A moved corner brought into the map: its edges of the polycube drawn on the surface again, where the rays of the
// unfolded region are. Triangles that they cross are cut, which changes neither what the map is nor its distortion.
#pragma once

#include "polycube/corners/corner_move.h"

namespace orbicube::polycube {

// `move` after an evaluation that was finite, of a region of `map`. False when rounding left a triangle without area or
// the region cannot be cut: then the map is spoiled, and what it was before should be used.
bool cut_region(const CornerMove& move, WorkingMap& map, const base::Host& host);

}  // namespace orbicube::polycube
