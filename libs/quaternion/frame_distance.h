// Distance and matching of frames: rotations up to the 24 of the cube, where q and q g stand for the same three axes.
// With Hamilton's product and active rotations the symmetry is on the right, so the distance of frames p and q is the
// smallest angle of q^-1 p g over the group: it does not change when either frame is replaced by an equal one, nor when
// both are rotated. It is at most 62.8 degrees. Nothing here branches on data, so that loops become vector
// instructions.
#pragma once

#include <array>

#include "quaternion/cube_group.h"
#include "quaternion/quaternion.h"

namespace orbicube::quaternion {

namespace detail {

constexpr double smaller(double a, double b) {
  return a < b ? a : b;
}
constexpr double larger(double a, double b) {
  return a > b ? a : b;
}

// asin(sqrt s) / sqrt s on [0, 0.28] to 3e-17: the minimum largest error of degree 13, by Chebyshev interpolation.
constexpr double arc_over_chord(double s) {
  constexpr std::array<double, 13> coefficient = {
      0.16666666666666674,  0.07499999999992399,   0.04464285715800273,  0.030381943262825294, 0.022372206804869146,
      0.01735162304978426,  0.013982267608260115,  0.011374940106786207, 0.010976996515992769, 0.0027509517953020527,
      0.024490741717994546, -0.025506484936081878, 0.035755212494070106};
  double sum = coefficient[12];
  for (std::size_t k = 12; k-- > 0;)
    sum = sum * s + coefficient[k];
  return 1 + s * sum;
}

}  // namespace detail

// sin^2(angle / 2) = 1 - max (r . g)^2 over the cube's rotations g, of the relative rotation r of length 1; at most
// 0.272. It is made of differences of the sorted components, which do not cancel: zero to the last bit for equal
// rotations, and as accurate as r itself elsewhere.
constexpr double cube_sine_square(const Quaternion& r) {
  using detail::larger;
  using detail::smaller;
  const double w = r.w < 0 ? -r.w : r.w, x = r.x < 0 ? -r.x : r.x, y = r.y < 0 ? -r.y : r.y, z = r.z < 0 ? -r.z : r.z;
  const double high = larger(w, x), low = smaller(w, x), high_too = larger(y, z), low_too = smaller(y, z);
  const double a1 = larger(high, high_too), a4 = smaller(low, low_too);
  const double inner = smaller(high, high_too), inner_too = larger(low, low_too);
  const double a2 = larger(inner, inner_too), a3 = smaller(inner, inner_too);
  const double smallest = a3 * a3 + a4 * a4;
  const double d12 = a1 - a2, d34 = a3 - a4, across = (a1 - a3) + (a2 - a4);
  const double one = a2 * a2 + smallest;
  const double two = 0.5 * (d12 * d12) + smallest;
  // The squares of d12 + d34 and d12 - d34 add up to twice those of d12 and d34.
  const double four = 0.25 * (across * across) + 0.5 * (d12 * d12 + d34 * d34);
  return smaller(one, smaller(two, four));
}

// sin^2 of half the distance of the frames p and q (units): the dissertation's energy 1 - s0^2 of eq. 6.10.
constexpr double symmetric_sine_square(const Quaternion& p, const Quaternion& q) {
  return cube_sine_square(relative(q, p));
}

// The distance of the frames p and q (units), in radians.
inline double symmetric_distance(const Quaternion& p, const Quaternion& q) {
  const double s = symmetric_sine_square(p, q);
  return 2 * (std::sqrt(s) * detail::arc_over_chord(s));
}

// The number g of the cube's rotation for which `from` g is nearest to `to`: to ~ from g.
constexpr std::uint32_t symmetric_matching(const Quaternion& from, const Quaternion& to) {
  return nearest_cube_rotation(relative(from, to));
}

}  // namespace orbicube::quaternion
