#pragma once

#include <Eigen/Core>

namespace orbicube::mesh {

// The third coordinate of the cross product: twice the signed area of the triangle 0, a, b.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace orbicube::mesh
