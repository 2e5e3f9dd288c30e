// The parameterization of a solid without frames: along a field that is computed for it.
#pragma once

#include "volume_map/frame_map/parameterization.h"

namespace orbicube::volume_map {

// Computes smooth fields, aligned with the boundary and with edges of it that turn by more than `feature_angle`
// (radians; 0: none), and changed where no map could follow: in places first, then about single axes, then both from
// harmonics without a search for lower energy. Returns the map along the first that one can follow; `solid` has its
// frames then and, with `split`, tetrahedra that are split for it (split_parameterization.h). Throws what
// parameterize() does, for the first field, and what frame_field::compute() does.
Parameterization parameterize_by_computed_frames(FramedSolid& solid, double feature_angle, bool split,
                                                 const ParameterizationOptions& options, const base::Host& host);

}  // namespace orbicube::volume_map
