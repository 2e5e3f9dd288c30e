// Shapes of triangles by numbers that do not depend on how a surface lies.
//
// A surface that is turned, moved or scaled has coordinates with other rounding errors. Optimization steps that are not
// convex magnify these from level to level of the hierarchy until the maps differ by degrees. Shapes are therefore
// rounded to far fewer bits than coordinates have, so that they are the same numbers, but for the few that lie where
// rounding changes: about one of 1e8 on a mesh of 1000 vertices.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace orbicube::sphere_map {

// Cotangents of a surface triangle's angles and its area.
struct TriangleShape {
  double cot_p, cot_q, cot_r, area;
};

// Bits that shapes are rounded to. More: rounding errors reach more shapes, first those of small triangles; fewer:
// energies change.
inline constexpr int shape_bits = 22;

// Rounds a number of [0, 1] to `bits` after the point.
inline double rounded_fraction(double x, int bits) {
  const double magnitude = std::ldexp(1.5, 52 - bits);
  return (x + magnitude) - magnitude;
}

// Rounds a positive number to shape_bits of its own (Dekker 1971).
inline double rounded_number(double x) {
  constexpr double factor = static_cast<double>(std::int64_t{1} << (53 - shape_bits)) + 1;
  const double scaled = factor * x;
  return scaled - (scaled - x);
}

// Sets the cotangents to those of the triangle whose squared sides are `squares` (of the sides opposite p, q, r),
// rounded as parts of their sum. Thin triangles get more bits, since their heights are differences; the thinnest stay
// as they are.
inline void round_angles(const std::array<double, 3>& squares, double twice_area, TriangleShape& shape) {
  constexpr int min_exponent = -10;
  const double sum = squares[0] + squares[1] + squares[2];
  // With this factor no triangle of a regular mesh lies where the number of bits changes.
  int exponent = 0;
  std::frexp(0.7137 * twice_area / sum, &exponent);
  if (!(twice_area > 0) || exponent < min_exponent) return;
  const int bits = shape_bits - 2 * exponent;
  const double p = rounded_fraction(squares[0] / sum, bits);
  const double q = rounded_fraction(squares[1] / sum, bits);
  const double r = rounded_fraction(squares[2] / sum, bits);
  const double over_area = 1 / std::sqrt(4 * p * q - (p + q - r) * (p + q - r));  // 1 / (4 area)
  shape.cot_p = (q + r - p) * over_area;
  shape.cot_q = (r + p - q) * over_area;
  shape.cot_r = (p + q - r) * over_area;
}

}  // namespace orbicube::sphere_map
