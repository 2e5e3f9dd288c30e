#include "mesh/features/feature_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbicube::mesh {

double degrees_between(const Vector3& a, const Vector3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

Vector3 triangle_normal(std::span<const Vector3> positions, const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  return (positions[b] - positions[a]).cross(positions[c] - positions[a]).stableNormalized();
}

FeatureLines::FeatureLines(std::span<const Vector3> positions, const Connectivity& connectivity, std::size_t triangles,
                           const base::Host& host)
    : positions_(positions), connectivity_(&connectivity), host_(&host), marked_(3 * triangles, 0, host.memory) {}

void FeatureLines::add_sharp(double angle, std::span<const Triangle> triangles) {
  for (Index h = 0; h < marked_.size(); ++h) {
    if (h % 4096 == 0) host_->report("features", h, marked_.size());
    const Index other = connectivity_->opposite(h);
    if (other == no_index || other < h) continue;
    const Vector3 left = triangle_normal(positions_, triangles[triangle_of(h)]);
    const Vector3 right = triangle_normal(positions_, triangles[triangle_of(other)]);
    if (left.isZero() || right.isZero()) continue;
    if (degrees_between(left, right) >= angle) add(h);
  }
}

Index FeatureLines::find(Index from, Index to) const {
  Index found = no_index;
  connectivity_->for_each_outgoing(from, [&](Index h) {
    if (connectivity_->end(h) == to) found = h;
  });
  return found;
}

std::size_t FeatureLines::degree(Index vertex) const {
  std::size_t count = 0;
  for_each(vertex, [&](Index) { ++count; });
  return count;
}

double FeatureLines::angle_at(Index vertex) const {
  std::array<Vector3, 2> way{Vector3::Zero(), Vector3::Zero()};
  std::size_t count = 0;
  for_each(vertex, [&](Index h) {
    if (count < 2) way[count] = positions_[connectivity_->end(h)] - positions_[vertex];
    ++count;
  });
  return degrees_between(way[0], way[1]);
}

bool FeatureLines::is_corner(Index vertex, double angle) const {
  const std::size_t n = degree(vertex);
  return n == 1 || n > 2 || (n == 2 && angle_at(vertex) < 180 - angle);
}

}  // namespace orbicube::mesh
