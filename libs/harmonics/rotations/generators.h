// Infinitesimal rotations of functions by their coefficients: (X_a g)(u) = d/dt g(exp(-t [a]) u) at t = 0, so that a
// small rotation by the vector w takes g to g + sum w_a X_a g + ... They are antisymmetric.
#pragma once

#include <array>

#include "harmonics/functions/coefficients.h"

namespace orbicube::harmonics {

// X_x g, X_y g, X_z g. O(degree^2).
std::array<Coefficients, 3> generators(const Coefficients& g);

}  // namespace orbicube::harmonics
