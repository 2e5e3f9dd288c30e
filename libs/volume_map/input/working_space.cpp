#include "volume_map/input/working_space.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/search/bounding_volume_tree.h"

namespace orbicube::volume_map {
namespace {

// Coordinates whose size lies within these powers of two stay as they are: fourth powers and their sums are in range.
constexpr int max_exponent = 100;
// A side of the solid's own box longer than long_sides times the next one is shortened to `kept` times that. From there
// on fewer than three cells are across for ten thousand in all.
constexpr double long_sides = 16, kept = 8;
// Of its own box that the solid fills: what fills more is not bent. What fills less may be, and is not straightened by
// stretching: see has_room().
constexpr double straight = 0.3;

// `at` has the position of each vertex.
template <class At>
double volume_of(const At& at, std::span<const mesh::Triangle> triangles, const Vector3& about) {
  double volume = 0;
  for (const mesh::Triangle& t : triangles) {
    const Vector3 a = at(t[0]) - about, b = at(t[1]) - about, c = at(t[2]) - about;
    volume += a.dot(b.cross(c)) / 6;
  }
  return std::abs(volume);
}

// The area that the surface has across an axis, without its sign, over 2: lines along the axis are in the solid for its
// volume over that, on average, each time they enter it.
template <class At>
double area_across(const At& at, std::span<const mesh::Triangle> triangles, const Vector3& axis) {
  double area = 0;
  for (const mesh::Triangle& t : triangles)
    area += std::abs((at(t[1]) - at(t[0])).cross(at(t[2]) - at(t[0])).dot(axis)) / 4;
  return area;
}

// Directions of the second moments of the surface by area, in columns, the longest last.
template <class At>
Eigen::Matrix3d axes_of(const At& at, std::span<const mesh::Triangle> triangles, const Vector3& about) {
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  Vector3 center = Vector3::Zero();
  double area = 0;
  for (const mesh::Triangle& t : triangles) {
    const Vector3 a = at(t[0]) - about, b = at(t[1]) - about, c = at(t[2]) - about;
    const double part = (b - a).cross(c - a).norm();
    const Vector3 sum = a + b + c;
    moments += part / 12 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
    center += part / 3 * sum;
    area += part;
  }
  center /= area;
  moments = moments / area - center * center.transpose();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(moments).eigenvectors();
}

}  // namespace

Vector3 times_power_of_two(const Vector3& p, int exponent) {
  const int half = exponent / 2;
  return p * std::ldexp(1.0, half) * std::ldexp(1.0, exponent - half);
}

int size_exponent(std::span<const Vector3> positions) {
  double size = 0;
  for (const Vector3& p : positions)
    size = std::max(size, p.cwiseAbs().maxCoeff());
  int exponent = 0;
  if (size > 0 && std::isfinite(size)) std::frexp(size, &exponent);
  return std::abs(exponent) > max_exponent ? exponent : 0;
}

WorkingSpace::WorkingSpace(std::span<const Vector3> given, std::span<const mesh::Triangle> triangles, int exponent)
    : exponent_(exponent) {
  const auto at = [&](Index v) { return exponent == 0 ? given[v] : times_power_of_two(given[v], -exponent); };
  mesh::Box box;
  for (const mesh::Triangle& t : triangles) {
    for (const Index v : t)
      box.add(at(v));
  }
  if (!box.low.allFinite() || !box.high.allFinite()) return;
  const Vector3 middle = 0.5 * (box.low + box.high);
  Eigen::Matrix3d axes = axes_of(at, triangles, middle);
  if (!axes.allFinite()) return;
  if (axes.determinant() < 0) axes.col(0) = -axes.col(0);
  mesh::Box own;
  for (const mesh::Triangle& t : triangles) {
    for (const Index v : t)
      own.add(axes.transpose() * (at(v) - middle));
  }
  // Shortest first; axes by moments may be in another order.
  const Vector3 sides = own.high - own.low;
  std::array<Eigen::Index, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) { return sides[a] < sides[b]; });
  const double thin = sides[order[0]], wide = sides[order[1]], length = sides[order[2]];
  if (!(thin > 0) || (length <= long_sides * wide && wide <= long_sides * thin)) return;
  const bool full = volume_of(at, triangles, middle) >= straight * sides.prod();
  const auto across = [&](std::size_t i) { return area_across(at, triangles, axes.col(order[i])); };
  // A flat or a long creature or frame is after that at most as thick along the shorter axis as along the longer one,
  // on average; a ring or a coil would become a ribbon.
  const auto has_room = [&](std::size_t shorter, double by) {
    return full || across(shorter) >= by * across(shorter + 1);
  };
  Vector3 factor = Vector3::Ones();
  if (wide > long_sides * thin && has_room(0, wide / (kept * thin))) factor[order[0]] = wide / (kept * thin);
  if (length > long_sides * wide && has_room(1, length / (kept * wide))) factor[order[2]] = kept * wide / length;
  if (factor == Vector3::Ones()) return;
  stretched_ = true;
  center_ = middle;
  to_ = factor.asDiagonal() * axes.transpose();
  back_ = axes * factor.cwiseInverse().asDiagonal();
}

Vector3 WorkingSpace::to(const Vector3& p) const {
  const Vector3 scaled = exponent_ == 0 ? p : times_power_of_two(p, -exponent_);
  return stretched_ ? Vector3(to_ * (scaled - center_)) : scaled;
}

}  // namespace orbicube::volume_map
