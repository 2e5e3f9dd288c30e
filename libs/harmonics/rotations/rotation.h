// Rotations of functions on the sphere by their coefficients. A rotation R takes the function g to (R g)(u) = g(R' u):
// what g has at direction v, R g has at direction R v. Degrees do not mix. Matrices are rotations: orthogonal with
// determinant 1.
#pragma once

#include <Eigen/Core>

#include "base/host.h"
#include "harmonics/functions/coefficients.h"

namespace orbicube::harmonics {

using Matrix3 = Eigen::Matrix3d;

// The coefficients of R g of every channel. O(degree^3).
// Throws Error: invalid-argument when R is no rotation (to 1e-9).
Coefficients rotate(const Coefficients& g, const Matrix3& rotation, const base::Host& host);

// The values turned instead, where the three channels are the coordinates of a shape: g'(u) = Q g(u).
void rotate_values(Coefficients& g, const Matrix3& rotation);

}  // namespace orbicube::harmonics
