// How smooth a field is: the energy sum w (1 - s0^2) over links, s0 the cosine of half the angle between the frames up
// to the 24 rotations of the cube (the dissertation's eq. 6.10, shifted so that a constant field has none).
#pragma once

#include "frame_field/graph/constraints.h"
#include "frame_field/graph/dual_graph.h"

namespace orbicube::frame_field {

// The same bits for any number of threads. O(n).
double energy(const DualGraph& graph, const Field& field, const base::Host& host);

// What the pulls at frames are worth, which is added to the energy where there are any.
double pull_energy(const Constraints& constraints, const Field& field);

}  // namespace orbicube::frame_field
