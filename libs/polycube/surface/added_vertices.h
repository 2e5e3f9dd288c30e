// Vertices that were added so that edges of the polycube could be drawn on the surface, taken out of the map again
// where no edge of the polycube needs them: the drawing's cuts inside faces leave unnecessary needles.
#pragma once

#include "polycube/layout/planar_star.h"

namespace orbicube::polycube {

// Collapses added vertices into neighbors in the same triangle of the input, or on the same edge of it for those on
// one, so that the surface in space stays what it is; vertices on edges of the polycube stay on them, corners stay.
// Each collapse keeps every triangle positive, exactly on the polycube, and lowers what distortion of angles and areas
// exceeds that of an isometry. `map.image` holds a valid map of every living triangle. Returns how many have gone.
std::size_t remove_added_vertices(EditableSurface& surface, const MapView& map, const base::Host& host);

}  // namespace orbicube::polycube
