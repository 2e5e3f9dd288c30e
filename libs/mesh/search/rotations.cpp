#include "mesh/search/rotations.h"

#include <Eigen/SVD>
#include <cmath>

namespace orbicube::mesh {

Eigen::Quaterniond rotation_between(const Vector3& a, const Vector3& b) {
  constexpr double opposite = -1 + 1e-12;
  const Vector3 from = a.normalized(), to = b.normalized();
  const double cosine = from.dot(to);
  Eigen::Quaterniond result;
  if (cosine < opposite) {
    result.w() = 0;
    result.vec() = from.unitOrthogonal();
    return result;
  }
  // Twice the cosine of half the angle; 1 + cosine is a small difference where they are nearly opposite.
  const double twice = cosine < -0.9 ? (from + to).norm() : std::sqrt(2 * (1 + cosine));
  result.w() = 0.5 * twice;
  result.vec() = (1 / twice) * from.cross(to);
  return result;
}

Eigen::Matrix3d nearest_rotation(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double handedness = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * Vector3(1, 1, handedness).asDiagonal() * svd.matrixV().transpose();
}

}  // namespace orbicube::mesh
