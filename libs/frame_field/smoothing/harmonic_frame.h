// Frames as spherical harmonics of degree 4 (Huang, Tong, Wei, Bao 2011; Ray, Sokolov, Levy 2016): the sum of the same
// bump about each of the six half axes, which is the same for frames that differ by a rotation of the cube, is a vector
// of nine numbers. A rotation of space rotates it, so averages and linear equations make sense; what comes out of them
// is brought back to the nearest frame.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "quaternion/frame_distance.h"
#include "quaternion/quaternion.h"

namespace orbicube::frame_field {

using quaternion::Quaternion;
using Vector = quaternion::Vector;

// Coefficients of the nine real harmonics of degree 4, orders -4 to 4; those of a frame have length 1.
using Harmonic = std::array<double, 9>;

// The harmonics at a point of the unit sphere, scaled so that the squares of all nine add up to 1.
Harmonic harmonics_at(const Vector& v);

// The coefficients of a frame.
Harmonic harmonic_of(const Quaternion& frame);

// A quarter of the gradient of the quartic form sum a_m S_m at v: T v v v, if the form is T v v v v.
Vector quartic_gradient(const Harmonic& a, const Vector& v);

inline double dot(const Harmonic& a, const Harmonic& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 9; ++k)
    sum += a[k] * b[k];
  return sum;
}

// Where a . harmonic_of(frame) is largest, found by Newton's method from `start`: a local maximum, which is the nearest
// frame to a when the start is near it.
Quaternion climb_to_frame(const Harmonic& a, const Quaternion& start);

// The nearest frame to any a but zero: climbs from a guess, and from those of a fixed set of starts, which lies
// everywhere within a few degrees, that are away from where that led and might lead higher.
Quaternion nearest_frame(const Harmonic& a, const Quaternion& guess);
// The same, with the best of the starts for a guess.
Quaternion nearest_frame(const Harmonic& a);

// Frames with an axis along a unit direction n make a circle in the nine numbers: center + cos(4 t) first +
// sin(4 t) second for the base frame turned by t about n. `first` and `second` have the same length and are orthogonal
// to each other and to the center.
struct AxisCircle {
  Harmonic centre, first, second;
};
AxisCircle axis_circle(const Quaternion& base_frame, const Vector& direction);
inline constexpr double circle_radius_square = 5.0 / 12.0;  // |first|^2

// Turns the frame by `angle` about a unit direction of space.
inline Quaternion turned(const Quaternion& frame, const Vector& direction, double angle) {
  const double c = std::cos(0.5 * angle), s = std::sin(0.5 * angle);
  return quaternion::normalized(quaternion::multiply({c, s * direction.x, s * direction.y, s * direction.z}, frame));
}

}  // namespace orbicube::frame_field
