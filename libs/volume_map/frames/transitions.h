// How coordinates change between charts: one of the 24 rotations of the cube and an integer translation. Between
// numbers without a rest that is exact.
#pragma once

#include "quaternion/cube_group.h"
#include "volume_map/types.h"

namespace orbicube::volume_map {

// x becomes M x + shift, M the matrix of the rotation.
struct Transition {
  std::uint8_t rotation = 0;
  std::array<std::int32_t, 3> shift{};

  bool operator==(const Transition&) const = default;

  // Which coordinate becomes this one, and its sign.
  static std::size_t source(std::uint8_t rotation, std::size_t axis) {
    const auto& m = quaternion::cube_group.matrix[rotation];
    return m[3 * axis] != 0 ? 0 : m[3 * axis + 1] != 0 ? 1 : 2;
  }
  static int sign(std::uint8_t rotation, std::size_t axis) {
    return quaternion::cube_group.matrix[rotation][3 * axis + source(rotation, axis)];
  }

  Vector3 operator()(const Vector3& x) const {
    Vector3 y;
    for (std::size_t a = 0; a < 3; ++a) {
      y[static_cast<Eigen::Index>(a)] =
          sign(rotation, a) * x[static_cast<Eigen::Index>(source(rotation, a))] + shift[a];
    }
    return y;
  }
  // Without the translation.
  Vector3 turn(const Vector3& x) const {
    Vector3 y;
    for (std::size_t a = 0; a < 3; ++a)
      y[static_cast<Eigen::Index>(a)] = sign(rotation, a) * x[static_cast<Eigen::Index>(source(rotation, a))];
    return y;
  }
};

// First b, then a.
inline Transition operator*(const Transition& a, const Transition& b) {
  Transition result{quaternion::cube_group.product[a.rotation][b.rotation], a.shift};
  for (std::size_t k = 0; k < 3; ++k)
    result.shift[k] += Transition::sign(a.rotation, k) * b.shift[Transition::source(a.rotation, k)];
  return result;
}

inline Transition inverse(const Transition& a) {
  Transition result{quaternion::cube_group.inverse[a.rotation], {}};
  for (std::size_t k = 0; k < 3; ++k) {
    result.shift[k] = -Transition::sign(result.rotation, k) * a.shift[Transition::source(result.rotation, k)];
  }
  return result;
}

}  // namespace orbicube::volume_map
