// How far a map of a triangle to the plane may go along a direction before the triangle flips.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace orbicube::untangle {

// The minimum t > 0 at which det(jacobian + t direction) vanishes, the smaller root of a quadratic; infinite without
// one.
inline double first_degenerate_step(const Eigen::Matrix2d& jacobian, const Eigen::Matrix2d& direction) {
  const Eigen::Matrix2d &j = jacobian, &k = direction;
  const double constant = j.determinant(), square = k.determinant();
  const double linear = j(0, 0) * k(1, 1) + k(0, 0) * j(1, 1) - j(0, 1) * k(1, 0) - k(0, 1) * j(1, 0);
  const double discriminant = linear * linear - 4 * square * constant;
  double root = std::numeric_limits<double>::infinity();
  if (std::abs(square) < 1e-300) {
    if (linear < 0) root = -constant / linear;
  } else if (discriminant >= 0) {
    const double half = -0.5 * (linear + std::copysign(std::sqrt(discriminant), linear));
    for (const double r : {half / square, constant / half}) {
      if (r > 0) root = std::min(root, r);
    }
  }
  return root;
}

}  // namespace orbicube::untangle
