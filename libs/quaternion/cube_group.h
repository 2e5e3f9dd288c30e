// The 24 rotations of the cube as a group, each by a number that says what it is:
//   0        none                                 1
//   1 .. 3   half turns about x, y, z             i, j, k
//   4 .. 9   quarter turns about x, -x, y, ...    (1 +- e) / sqrt 2
//   10 .. 15 half turns about edges (x y), (x -y), (x z), (x -z), (y z), (y -z)
//   16 .. 23 third turns about corners            (1 +- i +- j +- k) / 2, bits 0, 1, 2 of the number for a minus
// in the order of which the nearest one to any rotation is read off the components without a search.
#pragma once

#include <array>
#include <cstdint>

#include "quaternion/quaternion.h"

namespace orbicube::quaternion {

inline constexpr std::uint32_t cube_order = 24;

enum class CubeClass : std::int32_t { identity = 0, face_half = 1, face_quarter = 2, edge_half = 3, corner_third = 4 };

namespace detail {

inline constexpr double half_root = 0.70710678118654752440;  // 1 / sqrt 2

// The number of the pair a < b of components, in the order (w x) (w y) (w z) (x y) (x z) (y z).
constexpr std::uint32_t pair_number(std::uint32_t a, std::uint32_t b) {
  return a == 0 ? b - 1 : a + b;
}

}  // namespace detail

// The number of the rotation of the cube nearest to r, of any length but zero: largest |r . g| over all g of length 1,
// which is the largest of a1, (a1 + a2) / sqrt 2 and (a1 + a2 + a3 + a4) / 2 for the sorted magnitudes a1 >= ... >= a4
// of its components. Of equally near ones, the first kind in this order and then the first components.
constexpr std::uint32_t nearest_cube_rotation(const Quaternion& r) {
  const std::array<double, 4> c{r.w, r.x, r.y, r.z};
  std::array<double, 4> a{};
  for (std::size_t i = 0; i < 4; ++i)
    a[i] = c[i] < 0 ? -c[i] : c[i];
  std::uint32_t first = 0;
  for (std::uint32_t i = 1; i < 4; ++i)
    first = a[i] > a[first] ? i : first;
  std::uint32_t second = first == 0 ? 1 : 0;
  for (std::uint32_t i = second + 1; i < 4; ++i)
    second = i != first && a[i] > a[second] ? i : second;
  const double one = a[first], two = (a[first] + a[second]) * detail::half_root,
               four = 0.5 * ((a[0] + a[1]) + (a[2] + a[3]));
  if (one >= two && one >= four) return first;
  if (two >= four) {
    const std::uint32_t pair = detail::pair_number(first < second ? first : second, first < second ? second : first);
    return 4 + 2 * pair + ((c[first] < 0) != (c[second] < 0) ? 1 : 0);
  }
  std::uint32_t signs = 0;
  for (std::uint32_t i = 1; i < 4; ++i)
    signs |= ((c[i] < 0) != (c[0] < 0) ? 1U : 0U) << (i - 1);
  return 16 + signs;
}

// Tables of the group, filled in by the compiler from the quaternions.
struct CubeGroup {
  std::array<Quaternion, cube_order> element;
  std::array<std::array<std::uint8_t, cube_order>, cube_order> product;  // product[a][b] is a b: b first
  std::array<std::uint8_t, cube_order> inverse;
  std::array<CubeClass, cube_order> conjugacy_class;
  std::array<std::array<std::int8_t, 9>, cube_order> matrix;  // by rows
};
extern const CubeGroup cube_group;

}  // namespace orbicube::quaternion
