// The polycube that labels and the coordinates of their patches stand for, without a map to it.
#pragma once

#include "polycube/layout/drawn_construction.h"

namespace orbicube::polycube {

// A map of a labeled surface whose patches are flat, each in its plane, but whose triangles need not be positive: its
// patches as patches of a polycube, drawn on the surface again with the corners where they are and all else along where
// the map has it (drawn_construction.h). So a few triangles that stay flipped, or vertices that are in the way of one
// another, are no obstacle. Throws Error "unsupported" where the faces meet, "no-valid-result", "cancelled".
// `positions` and `triangles` are the surface before the map refined it.
Construction draw_labelled(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const SurfaceMap& map, const base::Host& host);

}  // namespace orbicube::polycube
