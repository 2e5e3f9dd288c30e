// All vertices of an unfolded map moved at once to where it is less distorted.
#pragma once

#include "polycube/unfolded/unfolded_star.h"

namespace orbicube::polycube {

// Steps of Newton's method with Gauss-Newton blocks (untangle/triangles), at most the given number, until one gains
// less than a part of the energy. Triangles stay positive, corners where they are. Returns how many steps it took.
// Throws Error "cancelled".
int move_all(UnfoldedMap& map, const TriangleWeights& weights, int steps, double min_gain, const base::Host& host);

}  // namespace orbicube::polycube
