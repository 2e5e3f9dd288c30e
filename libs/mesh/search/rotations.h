// Rotations found from directions.
#pragma once

#include <Eigen/Geometry>

#include "mesh/mesh.h"

namespace orbicube::mesh {

// The one without twist that takes direction a to direction b; of opposite directions half a turn about one of the axes
// between. Neither is zero. (Eigen's FromTwoVectors has a singular value decomposition in it for these, whose code
// takes ten seconds to compile.)
Eigen::Quaterniond rotation_between(const Vector3& a, const Vector3& b);

// The rotation R with the largest trace of R^T matrix (Kabsch 1976): with the sum of to * from^T over pairs of
// directions the one that brings `from` to `to` best. Where the best orthogonal matrix is a reflection, the direction
// of the minimum correlation is turned.
Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix);

}  // namespace orbicube::mesh
