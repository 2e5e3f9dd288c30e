// The energy of CubeCover (eqs. 5.3 to 5.6 of the dissertation): gradients of the coordinates follow the frames,
//   E = sum over tetrahedra of volume |grad f - X / cell|^2,
// a quadratic in the free variables and the integers of a seamless system.
#pragma once

#include <Eigen/Core>

#include "linear/sparse_system.h"
#include "volume_map/frames/seamless_system.h"

namespace orbicube::volume_map {

Eigen::Matrix3d matrix_of(const quaternion::Quaternion& q);

// What the coordinates of a tetrahedron's corners (by row), in its chart, cost: and the derivative by them, if
// requested.
double frame_energy(const std::array<Vector3, 4>& corners, const Eigen::Matrix3d& frame, double cell_length,
                    const Eigen::Matrix<double, 4, 3>& coordinates, Eigen::Matrix<double, 4, 3>* derivative = nullptr);

class FrameEnergy {
 public:
  // Frames are those of the cut. Keeps references. Throws Error "degenerate-geometry" where the system cannot be
  // factorized, "cancelled".
  FrameEnergy(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra, const FrameCut& cut,
              const SeamlessSystem& system, double cell_length, const base::Host& host);

  // With the best free variables for each choice of integers c the energy is a constant and (c - b)' A (c - b).
  const Eigen::MatrixXd& curvature() const { return curvature_; }
  const Eigen::VectorXd& best_integers() const { return best_; }
  // The real numbers of minimum energy: those above without what is added to the diagonal of the curvature.
  Eigen::VectorXd minimum() const;

  // The best free variables for these integers.
  Eigen::VectorXd free_variables(const Eigen::VectorXd& integers) const;

 private:
  struct Corners;

  // One coordinate of a tetrahedron: `square` of the gradients of its corners times the volume, `target` by corner.
  void add(const Corners& corners, const Eigen::Matrix4d& square, const Eigen::Vector4d& target,
           linear::SparseSystem::Triplets& mixed, Eigen::VectorXd& integer_right);

  const SeamlessSystem& system_;
  linear::SparseSystem::Triplets triplets_;
  std::optional<linear::SparseSystem> solver_;
  Eigen::SparseMatrix<double> mixed_;  // free variables by integers
  Eigen::VectorXd right_;
  Eigen::MatrixXd curvature_;
  double shift_ = 0;  // that is added to the diagonal of the curvature
  Eigen::VectorXd best_;
};

// All coordinates, 3 copy + axis, from free variables and integers.
void expand(const SeamlessSystem& system, const Eigen::VectorXd& free, const Eigen::VectorXd& integers,
            std::span<double> coordinates);

}  // namespace orbicube::volume_map
