// Random and awkward quaternions for the tests.
#pragma once

#include <doctest/doctest.h>

#include <random>
#include <vector>

#include "quaternion/quaternion.h"

namespace orbicube::test {

using quaternion::Quaternion;
using quaternion::Vector;

inline constexpr double ulp = 2.220446049250313e-16;

inline Quaternion random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return quaternion::normalized({w, x, y, z});
}

// Random rotations, and those about each axis and each pair of axes by angles from nothing to just about half a turn,
// where formulas that divide by a small component fail.
inline std::vector<Quaternion> many_rotations(std::size_t random_count = 200) {
  std::mt19937_64 random(7);
  std::vector<Quaternion> result;
  for (std::size_t i = 0; i < random_count; ++i)
    result.push_back(random_rotation(random));
  const double pi = std::acos(-1.0);
  for (const double angle :
       {0.0, 1e-300, 1e-160, 1e-16, 1e-9, 1e-4, 1.0, pi / 2, 3.0, pi - 1e-4, pi - 1e-9, pi - 1e-15, pi}) {
    for (int axis = 1; axis < 8; ++axis) {
      const double x = axis & 1, y = axis & 2 ? -1 : 0, z = axis & 4 ? 1 : 0, length = std::sqrt(x * x + y * y + z * z);
      const double sine = std::sin(angle / 2) / length;
      result.push_back({std::cos(angle / 2), sine * x, sine * y, sine * z});
    }
  }
  return result;
}

// Largest difference of the components of p and q, or of p and -q if that is less: of the rotations.
inline double apart(const Quaternion& p, const Quaternion& q) {
  const auto largest = [](const Quaternion& a, const Quaternion& b) {
    return std::max(std::max(std::abs(a.w - b.w), std::abs(a.x - b.x)),
                    std::max(std::abs(a.y - b.y), std::abs(a.z - b.z)));
  };
  return std::min(largest(p, q), largest(p, -q));
}

inline double length(const Quaternion& q) {
  return std::sqrt(quaternion::dot(q, q));
}

}  // namespace orbicube::test
