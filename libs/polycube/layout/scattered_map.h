// A smooth map of space through given points: an affine map and a sum of distances to the points, the interpolation
// that bends least (Duchon 1977, "Splines minimizing rotation-invariant semi-norms in Sobolev spaces").
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::polycube {

using base::Array;
using mesh::Vector3;

class ScatteredMap {
 public:
  // Takes each point to its image; points that are given twice go to the first of their images. A part of the affine
  // map that the points do not determine (fewer than four, or all in a plane) is a translation. `smoothing` of 0
  // interpolates, more lets points miss their images for less bending. O(n^3), memory for n^2 numbers that is not the
  // host's. Throws Error "cancelled".
  ScatteredMap(std::span<const Vector3> points, std::span<const Vector3> images, double smoothing,
               const base::Host& host);

  Vector3 operator()(const Vector3& x) const;
  // By columns, the derivatives along x, y and z.
  Eigen::Matrix3d derivative(const Vector3& x) const;

 private:
  Vector3 centre_ = Vector3::Zero();
  double scale_ = 1;
  Array<Vector3> points_, weights_;  // in units of scale_ from centre_
  Vector3 shift_ = Vector3::Zero();
  Eigen::Matrix3d linear_ = Eigen::Matrix3d::Identity();
};

}  // namespace orbicube::polycube
