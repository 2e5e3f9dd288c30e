// The six directions that a patch of a polycube can look in, numbered +x, -x, +y, -y, +z, -z.
#pragma once

#include <cstdint>

#include "mesh/mesh.h"

namespace orbicube::polycube {

using AxisLabel = std::uint8_t;
inline constexpr AxisLabel label_count = 6;

inline constexpr int axis_of(AxisLabel label) {
  return label / 2;
}
inline constexpr int sign_of(AxisLabel label) {
  return label % 2 == 0 ? 1 : -1;
}
inline constexpr AxisLabel opposite(AxisLabel label) {
  return label ^ 1U;
}
inline constexpr AxisLabel label_of(int axis, int sign) {
  return static_cast<AxisLabel>(2 * axis + (sign < 0 ? 1 : 0));
}
inline mesh::Vector3 direction_of(AxisLabel label) {
  return sign_of(label) * mesh::Vector3::Unit(axis_of(label));
}
// The third of two different axes.
inline constexpr int third_axis(int a, int b) {
  return 3 - a - b;
}

}  // namespace orbicube::polycube
