// The foldover-free energy of positive triangles: that of planar_triangles.h with eps 0, where chi is the determinant,
// and lambda 1, for a triangle of weight 1. It is evaluated without chi, in fewer operations and another order: the
// last bits differ from those of planar_triangles.h.
#pragma once

#include <limits>

#include <Eigen/Dense>

namespace orbicube::untangle {

// Returns the sum of angle and area distortion, each 1 for an isometry: |J|^2 / (2 det J) + (det J + 1 / det J) / 2.
// Infinite for what is not positive.
inline double barrier(const Eigen::Matrix2d& j) {
  const double d = j.determinant();
  return d > 0 ? 0.5 * (j.squaredNorm() / d + d + 1 / d) : std::numeric_limits<double>::infinity();
}

// Derivatives of the barrier by the entries of J, row by row; the block is the PSD projection of the Hessian.
struct BarrierDerivatives {
  explicit BarrierDerivatives(const Eigen::Matrix2d& j) {
    const double d = j.determinant(), squares = j.squaredNorm();
    const Eigen::Vector4d a(j(0, 0), j(0, 1), j(1, 0), j(1, 1));
    const Eigen::Vector4d c(j(1, 1), -j(1, 0), -j(0, 1), j(0, 0));
    gradient = a / d + (d - 0.5 * (squares + d * d + 1) / d) / d * c;
    const double q = (squares + 1) / (d * d);
    block = (Eigen::Matrix4d::Identity() - (c * a.transpose() + a * c.transpose()) / d + q * c * c.transpose()) / d;
  }

  Eigen::Vector4d gradient;
  Eigen::Matrix4d block;
};

}  // namespace orbicube::untangle
