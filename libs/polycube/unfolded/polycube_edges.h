// The polycube's edges found on an unfolded map: straight lines from corner to corner, where triangles are cut.
//
// Pieces of a triangle are mapped as the whole is, so that cuts leave the distortion as it is, however thin the pieces.
#pragma once

#include "polycube/unfolded/unfolded_map.h"

namespace orbicube::polycube {

// The map with every triangle in one patch of the polycube. Cuts map.surface, which is of no other use after that.
// Throws Error "no-valid-result" when rounding leads a line astray, "cancelled". Whether the result is valid is the
// certificate's to say (certificate.h).
SurfaceMap fold(UnfoldedMap& map, const base::Host& host);

}  // namespace orbicube::polycube
