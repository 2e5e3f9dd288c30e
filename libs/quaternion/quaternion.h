// Quaternions w + x i + y j + z k with Hamilton's product (i j = k). A unit quaternion q stands for the rotation that
// takes v to q v q^-1 (active), so the product p q rotates by q first; q and -q are the same rotation.
#pragma once

#include <cmath>

namespace orbicube::quaternion {

struct Vector {
  double x, y, z;
};

struct Quaternion {
  double w, x, y, z;
};

constexpr Quaternion operator-(const Quaternion& q) {
  return {-q.w, -q.x, -q.y, -q.z};
}

constexpr double dot(const Quaternion& p, const Quaternion& q) {
  return p.w * q.w + p.x * q.x + (p.y * q.y + p.z * q.z);
}

constexpr Quaternion conjugate(const Quaternion& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

constexpr Quaternion multiply(const Quaternion& p, const Quaternion& q) {
  return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
          p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}

// conjugate(q) p: for unit quaternions the rotation from frame q to frame p, seen in frame q. Real without rounding
// when p is q.
constexpr Quaternion relative(const Quaternion& q, const Quaternion& p) {
  return {q.w * p.w + q.x * p.x + (q.y * p.y + q.z * p.z), (q.w * p.x - q.x * p.w) + (q.z * p.y - q.y * p.z),
          (q.w * p.y - q.y * p.w) + (q.x * p.z - q.z * p.x), (q.w * p.z - q.z * p.w) + (q.y * p.x - q.x * p.y)};
}

// q scaled to length 1. Not a number for zero and for what is not finite.
inline Quaternion normalized(const Quaternion& q) {
  const double largest = std::fmax(std::fmax(std::abs(q.w), std::abs(q.x)), std::fmax(std::abs(q.y), std::abs(q.z)));
  // Lengths whose square is neither lost nor infinite need no scaling first.
  const bool plain = largest > 0x1p-500 && largest < 0x1p500;
  const Quaternion s = plain ? q : Quaternion{q.w / largest, q.x / largest, q.y / largest, q.z / largest};
  const double length = std::sqrt(dot(s, s));
  return {s.w / length, s.x / length, s.y / length, s.z / length};
}

// q^-1 = conjugate(q) / |q|^2, also for lengths whose square is lost or infinite. Infinite or not a number for zero.
inline Quaternion inverse(const Quaternion& q) {
  const double largest = std::fmax(std::fmax(std::abs(q.w), std::abs(q.x)), std::fmax(std::abs(q.y), std::abs(q.z)));
  const Quaternion s{q.w / largest, q.x / largest, q.y / largest, q.z / largest};
  const double square = dot(s, s);
  return {s.w / square / largest, -s.x / square / largest, -s.y / square / largest, -s.z / square / largest};
}

// q v q^-1 for a unit q.
constexpr Vector rotate(const Quaternion& q, const Vector& v) {
  const double tx = 2 * (q.y * v.z - q.z * v.y);
  const double ty = 2 * (q.z * v.x - q.x * v.z);
  const double tz = 2 * (q.x * v.y - q.y * v.x);
  return {v.x + (q.w * tx + (q.y * tz - q.z * ty)), v.y + (q.w * ty + (q.z * tx - q.x * tz)),
          v.z + (q.w * tz + (q.x * ty - q.y * tx))};
}

}  // namespace orbicube::quaternion
