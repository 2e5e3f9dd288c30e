// A traced surface made coarse by half-edge collapses that leave the drawing of the layout as it is: nodes stay, what
// is on an arc goes along its arc, and no edge comes to join two drawn vertices, so that every rectangle keeps a map to
// a convex shape with nothing flat in it. The collapses are undone one by one when the map is refined.
//
// The order is that of quadric errors (Garland and Heckbert 1997).
#pragma once

#include "polycube/layout/tracing.h"

namespace orbicube::polycube {

// The half-edges collapsed, in order; for EditableSurface::undo_collapse from the last to the first. Ends at
// `min_vertices`, or earlier when nothing more can go. O(n log n).
Array<Index> decimate(const Layout& layout, EditableSurface& surface, const Drawing& drawing, std::size_t min_vertices,
                      const base::Host& host);

}  // namespace orbicube::polycube
