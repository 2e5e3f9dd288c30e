#include "quaternion/cube_group.h"

namespace orbicube::quaternion {
namespace {

constexpr CubeGroup make_group() {
  using detail::half_root;
  CubeGroup group{};
  group.element[0] = {1, 0, 0, 0};
  group.element[1] = {0, 1, 0, 0};
  group.element[2] = {0, 0, 1, 0};
  group.element[3] = {0, 0, 0, 1};
  for (std::uint32_t a = 0; a < 4; ++a) {
    for (std::uint32_t b = a + 1; b < 4; ++b) {
      for (std::uint32_t minus = 0; minus < 2; ++minus) {
        std::array<double, 4> c{};
        c[a] = half_root;
        c[b] = minus ? -half_root : half_root;
        group.element[4 + 2 * detail::pair_number(a, b) + minus] = {c[0], c[1], c[2], c[3]};
      }
    }
  }
  for (std::uint32_t signs = 0; signs < 8; ++signs) {
    group.element[16 + signs] = {0.5, signs & 1 ? -0.5 : 0.5, signs & 2 ? -0.5 : 0.5, signs & 4 ? -0.5 : 0.5};
  }
  for (std::uint32_t a = 0; a < cube_order; ++a) {
    const Quaternion& q = group.element[a];
    group.inverse[a] = static_cast<std::uint8_t>(nearest_cube_rotation(conjugate(q)));
    for (std::uint32_t b = 0; b < cube_order; ++b) {
      group.product[a][b] = static_cast<std::uint8_t>(nearest_cube_rotation(multiply(q, group.element[b])));
    }
    group.conjugacy_class[a] = a == 0   ? CubeClass::identity
                               : a < 4  ? CubeClass::face_half
                               : a < 10 ? CubeClass::face_quarter
                               : a < 16 ? CubeClass::edge_half
                                        : CubeClass::corner_third;
    for (std::size_t column = 0; column < 3; ++column) {
      const Vector v = rotate(q, {column == 0 ? 1.0 : 0.0, column == 1 ? 1.0 : 0.0, column == 2 ? 1.0 : 0.0});
      const std::array<double, 3> turned{v.x, v.y, v.z};
      for (std::size_t row = 0; row < 3; ++row) {
        group.matrix[a][3 * row + column] = static_cast<std::int8_t>(turned[row] > 0.5    ? 1
                                                                     : turned[row] < -0.5 ? -1
                                                                                          : 0);
      }
    }
  }
  return group;
}

}  // namespace

constinit const CubeGroup cube_group = make_group();

}  // namespace orbicube::quaternion
