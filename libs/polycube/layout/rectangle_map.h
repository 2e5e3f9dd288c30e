// Every rectangle of a traced and decimated layout mapped to its rectangle on the polycube: boundaries by arc length,
// interiors by the mean-value weights (Floater 2003) of both ends of an edge together, within a factor of their median:
// they are positive, so that the map is a bijection (Tutte 1963, Floater 1997): the boundary is convex, and no edge
// joins two of its vertices. One sparse factor of the free vertices, O(n log n) for the few hundred that a coarse
// surface has.
#pragma once

#include "polycube/layout/layout.h"
#include "polycube/layout/tracing.h"

namespace orbicube::polycube {

// How far along its arc each vertex of a path is by length, from 0 to 1; of vertices on no path 0.
Array<double> arc_parameters(const EditableSurface& surface, const Drawing& drawing, const base::Host& host);

// Positions of the surface's vertices on the polycube. `parameter` as above, from before the surface was decimated.
// Throws Error "no-valid-result" when rounding spoils the map, "cancelled".
Array<Vector3> map_rectangles(const Layout& layout, const Drawing& drawing, const EditableSurface& surface,
                              std::span<const double> parameter, const base::Host& host);

}  // namespace orbicube::polycube
