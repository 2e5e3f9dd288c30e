// How the sphere of one shape's map corresponds to that of another: a rotation, then a warp between landmarks.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>

#include "base/host.h"
#include "sphere_map/correspondence/sphere_warp.h"

namespace orbicube::sphere_map {

using Matrix3 = Eigen::Matrix3d;

// The rotation R that minimizes the sum of |R from - to|^2 over directions, which are scaled to length 1 (Kabsch 1976,
// by singular values). What the pairs leave open, as a single one does, is turned by as little as can be.
// Throws Error "invalid-argument" on sizes, without a pair, and for what is no direction.
Matrix3 best_rotation(std::span<const Vector3> from, std::span<const Vector3> to);

class Alignment {
 public:
  Alignment() = default;  // the spheres correspond as they are
  // Throws Error "invalid-argument" when the matrix is no rotation (to 1e-9).
  explicit Alignment(const Matrix3& rotation);

  // Adds the warp that carries landmarks of the shape's sphere, rotated, onto those of the common one. What SphereWarp
  // throws.
  void add_warp(std::span<const Vector3> from, std::span<const Vector3> to, const base::Host& host);

  // From the shape's sphere to the common one, and back; unit vectors. Without rotation and warp, to the last bit as
  // they are.
  Vector3 to_common(const Vector3& direction) const;
  Vector3 from_common(const Vector3& direction) const;

  const Matrix3& rotation() const { return rotation_; }
  const SphereWarp* warp() const { return warp_.get(); }  // or null

 private:
  Matrix3 rotation_ = Matrix3::Identity();
  bool still_ = true;
  std::shared_ptr<const SphereWarp> warp_;
};

}  // namespace orbicube::sphere_map
