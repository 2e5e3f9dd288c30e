// Arcs between patches straightened, triangle by triangle.
#pragma once

#include "polycube/labels/label_cut.h"

namespace orbicube::polycube {

// Gives triangles at arcs the label across where that lowers the energy of labels and moves the arc over the triangle
// without changing how patches, arcs and corners hang together: around the triangle the labels must change twice or
// three times, to different ones, and both labels lie across an edge of it. Limited number of sweeps.
void smooth_labels(const Surface& surface, const LabelCosts& costs, int sweeps, std::span<AxisLabel> labels,
                   const base::Host& host);

}  // namespace orbicube::polycube
