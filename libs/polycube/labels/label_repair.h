// Labels changed until every patch can be the patch of a polycube by the rules of patches.h.
//
// Each pass removes single triangles that stick out, puts a strip of a third label between patches that look opposite
// ways, gives away the smallest fan where four patches meet, and bans the label of a patch that has too few corners or
// a handle, there, and cuts again. Bans persist, so that the passes end.
#pragma once

#include "polycube/labels/label_cut.h"
#include "polycube/labels/patches.h"

namespace orbicube::polycube {

// What was left wrong after at most `passes`: nothing when total() is 0. Bans are added to `costs`.
LabelFaults repair_labels(const Surface& surface, LabelCosts& costs, int passes, std::span<AxisLabel> labels,
                          const base::Host& host);

}  // namespace orbicube::polycube
