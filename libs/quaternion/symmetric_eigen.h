// The dominant eigenvector of a symmetric 4x4 matrix, by Jacobi's rotations (Golub and Van Loan, section 8.5): what
// averages of quaternions and nearest rotations come down to.
#pragma once

#include <array>

#include "quaternion/quaternion.h"

namespace orbicube::quaternion {

// 4x4 by rows, both triangles given.
using SymmetricMatrix = std::array<double, 16>;

struct Dominant {
  Quaternion vector;  // unit, of the largest eigenvalue; its sign means nothing
  double value, gap;  // the largest eigenvalue, and how far the next one is below it
  bool unique;        // the gap is more than rounding
};

// The entries must be finite.
Dominant dominant_eigenvector(const SymmetricMatrix& matrix);

}  // namespace orbicube::quaternion
