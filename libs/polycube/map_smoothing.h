// A certified map made smoother: vertices move within their faces of the polycube, along its edges, and not at its
// corners, never turning a triangle over.
#pragma once

#include "base/host.h"
#include "polycube/surface_map.h"

namespace orbicube::polycube {

// At most so many sweeps over all vertices, fewer when they gain little. Moves map.polycube and nothing else; the
// result is a valid map where the one given was. O(sweeps * n). Throws Error "cancelled".
void smooth_map(SurfaceMap& map, int sweeps, const base::Host& host);

}  // namespace orbicube::polycube
