// Labels changed until every chart can be the face of a polycube by the rules of charts.h.
//
// Each pass removes single triangles that stick out, puts a strip of a third label between charts that look opposite
// ways, gives away the smallest fan where four charts meet, and bans the label of a chart that has too few corners or a
// handle, there, and cuts anew. Bans persist, so that the passes end.
#pragma once

#include "polycube/charts.h"
#include "polycube/label_cut.h"

namespace orbicube::polycube {

// What was left wrong after at most `passes`: nothing when total() is 0. Bans are added to `costs`.
LabelFaults repair_labels(const Surface& surface, LabelCosts& costs, int passes, std::span<AxisLabel> labels,
                          const base::Host& host);

}  // namespace orbicube::polycube
