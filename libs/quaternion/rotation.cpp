#include "quaternion/rotation.h"

#include <algorithm>

#include "base/error.h"
#include "quaternion/symmetric_eigen.h"

namespace orbicube::quaternion {
namespace {

Quaternion scaled(const Quaternion& q, double factor) {
  return {factor * q.w, factor * q.x, factor * q.y, factor * q.z};
}

// Of the two quaternions of a rotation the one whose first component that is not zero is positive.
Quaternion canonical(const Quaternion& q) {
  for (const double component : {q.w, q.x, q.y, q.z}) {
    if (component != 0) return component < 0 ? -q : q;
  }
  return q;
}

}  // namespace

Quaternion from_axis_angle(const Vector& axis, double angle) {
  const double length = std::hypot(axis.x, axis.y, axis.z);
  if (!(length > 0) || !std::isfinite(length) || !std::isfinite(angle)) {
    throw base::Error("invalid-argument", "an axis must be finite and not zero, and its angle finite");
  }
  const double sine = std::sin(0.5 * angle);
  return {std::cos(0.5 * angle), sine * (axis.x / length), sine * (axis.y / length), sine * (axis.z / length)};
}

AxisAngle to_axis_angle(const Quaternion& q) {
  const double sine = std::hypot(q.x, q.y, q.z);
  if (!(sine > 0)) return {{1, 0, 0}, 0};
  const double sign = q.w < 0 ? -1 : 1;
  return {{sign * q.x / sine, sign * q.y / sine, sign * q.z / sine}, 2 * std::atan2(sine, std::abs(q.w))};
}

Quaternion from_rotation_vector(const Vector& v) {
  return exponential({0, 0.5 * v.x, 0.5 * v.y, 0.5 * v.z});
}

Vector to_rotation_vector(const Quaternion& q) {
  const AxisAngle turn = to_axis_angle(q);
  return {turn.angle * turn.axis.x, turn.angle * turn.axis.y, turn.angle * turn.axis.z};
}

Quaternion exponential(const Quaternion& q) {
  const double angle = std::hypot(q.x, q.y, q.z);
  const double size = std::exp(q.w);
  const double factor = angle > 0 ? std::sin(angle) / angle : 1.0;
  return scaled({std::cos(angle), factor * q.x, factor * q.y, factor * q.z}, size);
}

Quaternion logarithm(const Quaternion& q) {
  const double sine = std::hypot(q.x, q.y, q.z);
  const double size = std::log(std::hypot(q.w, sine));
  const double angle = std::atan2(sine, q.w);
  if (!(sine > 0)) return {size, q.w < 0 ? angle : 0.0, 0, 0};
  return {size, angle * (q.x / sine), angle * (q.y / sine), angle * (q.z / sine)};
}

Quaternion slerp(const Quaternion& p, const Quaternion& q, double t) {
  const Quaternion end = dot(p, q) < 0 ? -q : q;
  const Quaternion difference{end.w - p.w, end.x - p.x, end.y - p.y, end.z - p.z};
  const Quaternion sum{end.w + p.w, end.x + p.x, end.y + p.y, end.z + p.z};
  // By its tangent, the angle is accurate also where it is small.
  const double angle = 2 * std::atan2(std::sqrt(dot(difference, difference)), std::sqrt(dot(sum, sum)));
  const double sine = std::sin(angle);
  if (!(sine > 0)) return p;
  const double a = std::sin((1 - t) * angle) / sine, b = std::sin(t * angle) / sine;
  return normalized({a * p.w + b * end.w, a * p.x + b * end.x, a * p.y + b * end.y, a * p.z + b * end.z});
}

Matrix to_matrix(const Quaternion& q) {
  const double xx = 2 * q.x * q.x, yy = 2 * q.y * q.y, zz = 2 * q.z * q.z;
  const double xy = 2 * q.x * q.y, xz = 2 * q.x * q.z, yz = 2 * q.y * q.z;
  const double wx = 2 * q.w * q.x, wy = 2 * q.w * q.y, wz = 2 * q.w * q.z;
  return {1 - (yy + zz), xy - wz, xz + wy, xy + wz, 1 - (xx + zz), yz - wx, xz - wy, yz + wx, 1 - (xx + yy)};
}

Quaternion from_matrix(const Matrix& m) {
  constexpr double orthonormal = 1e-6;
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const double product = m[i] * m[j] + m[3 + i] * m[3 + j] + m[6 + i] * m[6 + j];
      const double breach = std::abs(product - (i == j ? 1.0 : 0.0));
      worst = breach <= worst ? worst : breach;  // takes what is not a number
    }
  }
  const double determinant =
      m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
  if (!(worst <= orthonormal && determinant > 0)) {
    throw base::Error("invalid-argument", "the matrix is no rotation");
  }
  // Four times the square of each component; they add up to 4, so one of them is at least 1.
  const double w = 1 + m[0] + m[4] + m[8], x = 1 + m[0] - m[4] - m[8];
  const double y = 1 - m[0] + m[4] - m[8], z = 1 - m[0] - m[4] + m[8];
  const double largest = std::max({w, x, y, z});
  Quaternion q;
  if (w == largest) {
    q = {w, m[7] - m[5], m[2] - m[6], m[3] - m[1]};
  } else if (x == largest) {
    q = {m[7] - m[5], x, m[1] + m[3], m[2] + m[6]};
  } else if (y == largest) {
    q = {m[2] - m[6], m[1] + m[3], y, m[5] + m[7]};
  } else {
    q = {m[3] - m[1], m[2] + m[6], m[5] + m[7], z};
  }
  return canonical(normalized(q));
}

Quaternion nearest_to_matrix(const Matrix& m) {
  double size = 0;
  for (const double entry : m)
    size = std::abs(entry) <= size ? size : std::abs(entry);  // takes what is not a number
  if (!(size > 0) || !std::isfinite(size)) throw base::Error("no-valid-result", "the matrix is zero or not finite");
  Matrix s;
  std::transform(m.begin(), m.end(), s.begin(), [&](double entry) { return entry / size; });
  // trace(R(q)' M) = q'Kq for a unit q.
  const SymmetricMatrix k{s[0] + s[4] + s[8], s[7] - s[5],        s[2] - s[6],        s[3] - s[1],  //
                          s[7] - s[5],        s[0] - s[4] - s[8], s[1] + s[3],        s[2] + s[6],  //
                          s[2] - s[6],        s[1] + s[3],        s[4] - s[0] - s[8], s[5] + s[7],  //
                          s[3] - s[1],        s[2] + s[6],        s[5] + s[7],        s[8] - s[0] - s[4]};
  const Dominant dominant = dominant_eigenvector(k);
  if (!dominant.unique) throw base::Error("no-valid-result", "the matrix has no unique nearest rotation");
  return canonical(dominant.vector);
}

}  // namespace orbicube::quaternion
