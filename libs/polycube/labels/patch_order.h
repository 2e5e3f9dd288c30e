// Which patches come before which along their axis, as the signs of arcs say.
#pragma once

#include "polycube/labels/arc_signs.h"

namespace orbicube::polycube {

// Each arc runs from one patch to another along its axis, up or down as its sign says. Returns the arcs on or between
// cycles, arcs from a patch to itself among them: while there are any no polycube has these signs. O(n) an arc that is
// left.
Array<Index> arcs_without_order(const Patches& patches, const ArcNetwork& network, const ArcSigns& signs,
                                const base::Host& host);

}  // namespace orbicube::polycube
