// Simple fields to smooth from. They satisfy the constraints.
#pragma once

#include "frame_field/constraints.h"
#include "frame_field/dual_graph.h"

namespace orbicube::frame_field {

// The axes of space everywhere, and turned as little as possible where the boundary wants it: the dissertation's
// initial guess (section 6.2).
Field identity_start(const DualGraph& graph, const Constraints& constraints, const base::Host& host);

// Every free frame is that of the nearest constrained one, counted in links; of several equally near, of the one whose
// node is first. O(n).
Field propagated_start(const DualGraph& graph, const Constraints& constraints, const base::Host& host);

}  // namespace orbicube::frame_field
