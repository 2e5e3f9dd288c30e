// Simple fields to smooth from. They satisfy the constraints.
#pragma once

#include "frame_field/graph/constraints.h"
#include "frame_field/graph/dual_graph.h"

namespace orbicube::frame_field {

// The same axes everywhere, and turned as little as possible where the boundary wants it. With the axes of space this
// is the dissertation's initial guess (section 6.2).
Field constant_start(const DualGraph& graph, const Constraints& constraints, const Quaternion& axes,
                     const base::Host& host);

// Every free frame is that of the nearest constrained one, counted in links; of several equally near, of the one whose
// node is first. The constrained ones are as near to the axes as they may be. O(n).
Field propagated_start(const DualGraph& graph, const Constraints& constraints, const Quaternion& axes,
                       const base::Host& host);

}  // namespace orbicube::frame_field
