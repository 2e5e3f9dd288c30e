// Labels changed where no signs of arcs make them those of a polycube (arc_signs.h), or where it has too many corners.
#pragma once

#include "polycube/labels/label_cut.h"
#include "polycube/labels/patches.h"

namespace orbicube::polycube {

// `labels` obey the rules of patches.h and go on doing so. In each step the patches where signs conflict, and those
// beside them, lose their labels one at a time, the smallest first; the remaining labels are cut and repaired again,
// and the change that leaves least conflict is kept. Ends when there is none, when no change helps, or when
// `max_changes` have been tried, from which those that were are taken off. The same is done with the smallest patches
// of all while there are more corners than `max_corners`, unless that is 0. Returns how much conflict is left: 0 when
// signs were found within the budget of corners. Bans are added to `costs`.
double search_labels(const Surface& surface, LabelCosts& costs, std::size_t max_corners, std::uint64_t seed,
                     std::size_t& max_changes, std::span<AxisLabel> labels, const base::Host& host);

}  // namespace orbicube::polycube
