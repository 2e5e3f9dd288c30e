// Chapter 6 of the dissertation as printed, so that its tables can be made again: frames are identity inside, those on
// the boundary are fixed, the matchings pi_ij are rounded once at the start and kept ("this rounding is necessary since
// it is very difficult to solve the problem if pi_ij changes discretely", section 6.1.3), and eq. 6.12 is minimized
// over the unit quaternions by the great-circle search of its reference [67], Algorithm 2 (sphere_optimizer).
//
// The boundary frames of its experiments came with the data of another method. Where none are given, they are those of
// identity, turned as little as possible towards the normals.
#pragma once

#include "frame_field/frame_field.h"

namespace orbicube::frame_field {

// `axes`: those of space in the axes of the graph's solid. The field is by node. Throws Error "cancelled".
Outcome dissertation_method(const DualGraph& graph, const Constraints& constraints, const Quaternion& axes,
                            const base::Host& host);

}  // namespace orbicube::frame_field
