// A triangle's energy with its first and second derivatives in the tangent coordinates of its three corners.
#pragma once

#include <array>

#include "sphere_map/optimization/distortion.h"

namespace orbicube::sphere_map {

// Coordinates are those of TangentBasis at each corner. The curvature of the sphere is taken off the diagonal: these
// are the Riemannian gradient and Hessian, but for d^-2, which counts as constant in second derivatives.
struct TriangleModel {
  double value;
  std::array<Eigen::Vector2d, 3> gradient;
  std::array<Eigen::Matrix2d, 3> diagonal;  // of each corner with itself
  std::array<Eigen::Matrix2d, 3> next;      // of each corner (rows) with the one after it (columns)
};

TriangleModel triangle_model(const Energy& energy, const TriangleShape& shape, const std::array<Vector3, 3>& corners);

}  // namespace orbicube::sphere_map
