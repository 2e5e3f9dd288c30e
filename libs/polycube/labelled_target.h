// The polycube that labels and the coordinates of their charts stand for, without a map to it.
#pragma once

#include "polycube/drawn_construction.h"

namespace orbicube::polycube {

// A map of a labelled surface whose charts are flat, each in its plane, but whose triangles need not be positive: its
// charts as faces of a polycube, drawn on the surface anew with the corners where they are and all else along where the
// map has it (drawn_construction.h). So a few triangles that stay turned over, or vertices that are in the way of one
// another, are no obstacle. Throws Error "unsupported" where the faces meet, "no-valid-result", "cancelled".
// `positions` and `triangles` are the surface before the map refined it.
Construction draw_labelled(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const SurfaceMap& map, const base::Host& host);

}  // namespace orbicube::polycube
