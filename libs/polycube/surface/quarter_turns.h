// Rotations of the plane by quarter turns, which are exact.
#pragma once

#include <Eigen/Core>
#include <numbers>

namespace orbicube::polycube {

using Eigen::Vector2d;

inline constexpr double quarter_turn = 0.5 * std::numbers::pi;

// Returns p rotated counter-clockwise by the given number of quarter turns, of any sign.
inline Vector2d turned_by(const Vector2d& p, int quarters) {
  switch (quarters & 3) {
    case 1:
      return {-p.y(), p.x()};
    case 2:
      return -p;
    case 3:
      return {p.y(), -p.x()};
    default:
      return p;
  }
}

}  // namespace orbicube::polycube
