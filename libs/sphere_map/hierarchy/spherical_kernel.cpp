#include "sphere_map/hierarchy/spherical_kernel.h"

#include <Eigen/Geometry>
#include <cmath>

#include "sphere_map/optimization/distortion.h"

namespace orbicube::sphere_map {
namespace {

using Eigen::Vector2d;

bool sees_ring(const Vector3& point, std::span<const Index> ring, std::span<const Vector3> directions) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Index next = ring[i + 1 < ring.size() ? i + 1 : 0];
    if (!safely_positive(point, directions[ring[i]], directions[next])) return false;
  }
  return true;
}

}  // namespace

bool KernelPolygon::cut(std::span<const Index> ring, std::span<const Vector3> directions, const Vector3& origin,
                        Index through) {
  const TangentBasis basis(origin);
  origin_ = origin;
  first_ = basis.first;
  second_ = basis.second;
  double reach_square = 0;
  for (const Index v : ring)
    reach_square = std::max(reach_square, (directions[v] - origin).squaredNorm());
  // The ring lies within this square of the tangent plane unless it is large, where the hemisphere is nearly all of it.
  reach_ = reach_square > 0.25 ? 4 : 2 * std::sqrt(reach_square);

  corners_ = {Vector2d(-1, -1), Vector2d(1, -1), Vector2d(1, 1), Vector2d(-1, 1)};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Index a = ring[i];
    const Index b = ring[i + 1 < ring.size() ? i + 1 : 0];
    const Vector3& q = directions[a];
    const Vector3& r = directions[b];
    const Vector3 normal = (q - origin).cross(r - origin);
    const Vector3 circle = normal - origin.cross(q - r);  // q x r, by differences
    const Vector2d slope = reach_ * Vector2d(circle.dot(first_), circle.dot(second_));
    const double length = slope.norm();
    if (!(length > 0)) return false;
    const double offset = a == through || b == through ? 0 : origin.dot(normal);
    clip(offset / length, slope / length);
    if (corners_.size() < 3) return false;
  }
  return true;
}

// Keeps the part where offset + slope . x > 0 (Sutherland and Hodgman 1974).
void KernelPolygon::clip(double offset, const Vector2d& slope) {
  clipped_.clear();
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vector2d& a = corners_[i];
    const Vector2d& b = corners_[i + 1 < corners_.size() ? i + 1 : 0];
    const double at_a = offset + slope.dot(a);
    const double at_b = offset + slope.dot(b);
    if (at_a > 0) clipped_.push_back(a);
    if ((at_a > 0) != (at_b > 0)) clipped_.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  std::swap(corners_, clipped_);
}

Vector3 KernelPolygon::lift(const Vector2d& x) const {
  return (origin_ + reach_ * (x.x() * first_ + x.y() * second_)).normalized();
}

std::optional<Vector3> KernelPolygon::area_centroid() const {
  Vector2d sum = Vector2d::Zero();
  double area = 0;
  for (std::size_t i = 1; i + 1 < corners_.size(); ++i) {
    const Vector2d a = corners_[i] - corners_[0];
    const Vector2d b = corners_[i + 1] - corners_[0];
    const double twice = a.x() * b.y() - a.y() * b.x();
    area += twice;
    sum += twice * (a + b);
  }
  if (!(area > 0)) return std::nullopt;
  return lift(corners_[0] + sum / (3 * area));
}

Vector3 KernelPolygon::corner_mean(double factor) const {
  Vector2d sum = Vector2d::Zero();
  for (const Vector2d& c : corners_)
    sum += c;
  return lift(factor / static_cast<double>(corners_.size()) * sum);
}

std::optional<Vector3> kernel_centroid(std::span<const Index> ring, Index kept, std::span<const Vector3> directions,
                                       KernelPolygon& polygon) {
  if (!polygon.cut(ring, directions, directions[kept], kept)) return std::nullopt;
  if (const auto point = polygon.area_centroid(); point && sees_ring(*point, ring, directions)) return point;
  // A kernel so thin that rounding pushes the centroid out of it: other points of it, nearer to `kept` each time.
  for (double factor = 1; factor > 1e-12; factor *= 0.5) {
    const Vector3 point = polygon.corner_mean(factor);
    if (sees_ring(point, ring, directions)) return point;
  }
  return std::nullopt;
}

}  // namespace orbicube::sphere_map
