// The rotation that turns as much of a surface as possible towards the axes.
#pragma once

#include "polycube/surface/surface.h"

namespace orbicube::polycube {

// Minimizes the sum over triangles of area |R n|_1 (Huang, Jiang, Shi, Tong, Bao and Desbrun 2014, l1-based polycubes):
// each term is least where the normal is along an axis. Of the 24 rotations that are equally good the one nearest to
// the identity is taken, and the identity itself unless another is better by a little.
Eigen::Matrix3d best_alignment(const Surface& surface, std::uint64_t seed, const base::Host& host);

}  // namespace orbicube::polycube
