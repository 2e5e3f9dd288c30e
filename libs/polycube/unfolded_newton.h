// All vertices of an unfolded map moved at once to where it is less distorted.
#pragma once

#include "polycube/unfolded_star.h"

namespace orbicube::polycube {

// Steps of Newton's method with Gauss-Newton blocks (untangling.h), at most so many, until one gains little. Triangles
// stay positive, corners where they are. Throws Error "cancelled".
void move_all(UnfoldedMap& map, const TriangleWeights& weights, int steps, const base::Host& host);

}  // namespace orbicube::polycube
