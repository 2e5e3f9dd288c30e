// Takes the best of two fields: where they differ, each connected region is taken over from the other field if the
// energy of the whole falls by it. Fields from different starts agree but for smooth differences away from their
// singular curves, so curves are chosen one by one.
#pragma once

#include "frame_field/graph/constraints.h"
#include "frame_field/graph/dual_graph.h"

namespace orbicube::frame_field {

// Returns by how much the energy of `field` fell. Frames that differ by less than `angle` (radians) count as the same.
// O(n).
double take_better_regions(const DualGraph& graph, const Constraints& constraints, const Field& other, double angle,
                           const base::Host& host, Field& field);

}  // namespace orbicube::frame_field
