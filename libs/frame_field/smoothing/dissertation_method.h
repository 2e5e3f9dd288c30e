// Chapter 6 of the dissertation as printed, so that its tables can be made again: frames are identity inside, those on
// the boundary are fixed, the matchings pi_ij are rounded once at the start and kept ("this rounding is necessary since
// it is very difficult to solve the problem if pi_ij changes discretely", section 6.1.3), and eq. 6.12 is minimized
// over the unit quaternions by the great-circle search of its reference [67], Algorithm 2 (sphere_optimizer).
//
// Where this departs from section 6.1.4: there the matchings pi_ij are unknowns too, unit quaternions that are rounded
// to one of the 24 rotations afterwards, and eq. 6.12 is a sextic in q_i, q_j and pi_ij. That sextic says nothing of
// the frames: pi_ij = (q_j q_i^-1)^-1 has s0_ij = 1 on every face, the minimum, whatever the frames are
// (tests/frame_field/frame_field_test.cpp), so that all fields are minima, and the start and the time of stopping
// decide the result. Rounding comes first here, which fixes the energy of the frames: pi_ij is the rotation that is
// nearest to (q_j q_i^-1)^-1 for the start, as rounding afterwards has it where the frames have not moved.
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
