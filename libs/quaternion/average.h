// The mean of rotations (Markley, Cheng, Crassidis, Oshman 2007, "Averaging quaternions"): the unit q that maximizes
// sum w_i (q . q_i)^2, the dominant eigenvector of sum w_i q_i q_i'. The signs of the q_i do not matter.
#pragma once

#include <cstddef>

#include "quaternion/quaternion.h"

namespace orbicube::quaternion {

struct Average {
  Quaternion mean;   // unit, on the side of the first quaternion with a weight
  double agreement;  // sum w_i (mean . q_i)^2 / sum w_i: 1 when all are the same rotation
};

// Of `count` rotations, w x y z each; `weights` has `count` entries or is null (all alike). Throws invalid-argument
// when there is no quaternion, one is not finite, or weights are negative, not finite or all zero; no-valid-result when
// no mean is better than all others.
Average average(const double* rotations, const double* weights, std::size_t count);

}  // namespace orbicube::quaternion
