// Triangles in space and their maps to planes, whose energy is that of untangle/triangles/barrier.h.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

// A triangle in space: gradients of its hat functions in its own plane, and its area.
struct RestTriangle {
  std::array<Eigen::Vector2d, 3> hat;
  double area;
};

// From the edges to the second and the third corner. Needles count as wider than they are: what is flatter than that
// has no angles to speak of.
inline RestTriangle rest_triangle(const Vector3& first, const Vector3& second) {
  constexpr double min_height = 1e-3, min_length = 1e-9;
  const double longest =
      std::sqrt(std::max({first.squaredNorm(), second.squaredNorm(), (second - first).squaredNorm()}));
  const double base = std::max({first.norm(), min_height * longest, min_length});
  const double along = first.norm() > 0 ? second.dot(first) / first.norm() : 0;
  const double height = std::max({first.cross(second).norm() / base, min_height * longest, min_height * min_length});
  RestTriangle t;
  t.hat[1] = {1 / base, -along / (base * height)};
  t.hat[2] = {0, 1 / height};
  t.hat[0] = -t.hat[1] - t.hat[2];
  t.area = 0.5 * base * height;
  return t;
}

// With the corners at a, b and c.
inline Eigen::Matrix2d jacobian(const RestTriangle& t, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                const Eigen::Vector2d& c) {
  return a * t.hat[0].transpose() + b * t.hat[1].transpose() + c * t.hat[2].transpose();
}

}  // namespace orbicube::polycube
