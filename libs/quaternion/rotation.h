// Unit quaternions to and from the other ways of writing a rotation: axis and angle, rotation vector, 3x3 matrix; and
// exponential, logarithm and slerp (Shoemake 1985).
#pragma once

#include <array>

#include "quaternion/quaternion.h"

namespace orbicube::quaternion {

// R with R v = q v q^-1, by rows.
using Matrix = std::array<double, 9>;

// Turns by `angle` radians about `axis`, counter-clockwise seen against it. The axis needs no unit length; throws
// invalid-argument when it is zero or not finite.
Quaternion from_axis_angle(const Vector& axis, double angle);

struct AxisAngle {
  Vector axis;   // unit; (1, 0, 0) where the angle is zero
  double angle;  // from 0 to pi
};
AxisAngle to_axis_angle(const Quaternion& q);

// The rotation by |v| radians about v, exp(v / 2); and its inverse, with |v| <= pi.
Quaternion from_rotation_vector(const Vector& v);
Vector to_rotation_vector(const Quaternion& q);

// e^q of any quaternion.
Quaternion exponential(const Quaternion& q);
// Principal logarithm: (log |q|, axis times angle) with an angle from 0 to pi, so that exponential(logarithm(q)) = q.
// The axis of a negative real q is x; -infinity in w for zero.
Quaternion logarithm(const Quaternion& q);

// The point that divides the shorter arc from the rotation p to q as t : 1 - t, at constant speed; t outside [0, 1]
// goes on along the same great circle. p at t = 0, q or -q at t = 1.
Quaternion slerp(const Quaternion& p, const Quaternion& q, double t);

Matrix to_matrix(const Quaternion& q);
// The unit quaternion with w >= 0 of a rotation matrix, to rounding for every rotation: of Shepperd's four formulas
// (1978) the one with the largest component, never one that cancels. Throws invalid-argument unless R'R is the unit
// matrix to 1e-6 and det R > 0.
Quaternion from_matrix(const Matrix& matrix);
// The rotation R that maximizes the trace of R'M, which is nearest to M in the Frobenius norm (Davenport's q-method:
// the dominant eigenvector of a 4x4 matrix); for a rotation with noise, or for columns to be made orthonormal. Throws
// no-valid-result when M is not finite or has no unique nearest rotation, such as zero or a reflection.
Quaternion nearest_to_matrix(const Matrix& matrix);

}  // namespace orbicube::quaternion
