#include "mesh/search/nearest.h"

#include <Eigen/Geometry>
#include <cmath>

namespace orbicube::mesh {
namespace {

// Share of the way from a to b at which the segment is nearest to p.
double nearest_on_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const double length = (b - a).squaredNorm();
  return length > 0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
}

Array<Box> boxes_of(std::span<const Vector3> positions, const base::Host& host) {
  Array<Box> boxes(positions.size(), host.memory);
  for (std::size_t v = 0; v < positions.size(); ++v)
    boxes[v].add(positions[v]);
  return boxes;
}

}  // namespace

TrianglePoint nearest_on_triangle(const Vector3& p, const Vector3& a, const Vector3& b, const Vector3& c) {
  // Above the triangle's inside, the foot of the perpendicular; else a point of one of the edges.
  const Vector3 normal = (b - a).cross(c - a);
  const double size = normal.squaredNorm();
  if (size > 0) {
    const auto weight = [&](const Vector3& from, const Vector3& to) { return (to - from).cross(p - from).dot(normal); };
    const Vector3 weights = Vector3(weight(b, c), weight(c, a), weight(a, b)) / size;
    if (weights.minCoeff() >= 0) {
      const Vector3 w = weights / weights.sum();
      return {w[0] * a + w[1] * b + w[2] * c, w};
    }
  }
  const std::array<const Vector3*, 3> corner = {&a, &b, &c};
  TrianglePoint best;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Index j = (i + 1) % 3;
    const Vector3& from = *corner[static_cast<std::size_t>(i)];
    const Vector3& to = *corner[static_cast<std::size_t>(j)];
    const double share = nearest_on_segment(p, from, to);
    const Vector3 at = share == 1 ? to : Vector3(from + share * (to - from));
    const double distance = (at - p).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    best.position = at;
    best.weights.setZero();
    best.weights[i] = 1 - share;
    best.weights[j] = share;
  }
  return best;
}

VertexSearch::VertexSearch(std::span<const Vector3> positions, const base::Host& host)
    : positions_(positions), tree_(boxes_of(positions, host), host) {}

Index VertexSearch::nearest(const Vector3& p) const {
  return tree_.nearest(p, [&](Index v) { return (positions_[v] - p).squaredNorm(); }).item;
}

SurfaceSearch::SurfaceSearch(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                             const base::Host& host)
    : positions_(positions), triangles_(triangles), tree_(mesh::boxes_of(positions, triangles, host), host) {}

TrianglePoint SurfaceSearch::on(Index triangle, const Vector3& p) const {
  const Triangle& t = triangles_[triangle];
  return nearest_on_triangle(p, positions_[t[0]], positions_[t[1]], positions_[t[2]]);
}

Box SurfaceSearch::box_of(Index triangle) const {
  const Triangle& t = triangles_[triangle];
  const Vector3 &a = positions_[t[0]], &b = positions_[t[1]], &c = positions_[t[2]];
  return {a.cwiseMin(b).cwiseMin(c), a.cwiseMax(b).cwiseMax(c)};
}

SurfacePoint SurfaceSearch::nearest(const Vector3& p, Index may_be_near) const {
  BoundingVolumeTree::Nearest start;
  if (may_be_near != no_index) start = {may_be_near, squared_distance(may_be_near, p)};
  double least = start.squared_distance;
  const auto distance = [&](Index t) {
    // Half of the triangles in leaves are too far by their own boxes.
    if (box_of(t).squared_distance(p) > least) return std::numeric_limits<double>::infinity();
    const double d = squared_distance(t, p);
    least = std::min(least, d);
    return d;
  };
  return point_of(tree_.nearest(p, distance, start), p);
}

SurfacePoint SurfaceSearch::point_of(const BoundingVolumeTree::Nearest& found, const Vector3& p) const {
  SurfacePoint result;
  // Among triangles that are as far as can be none is the nearest.
  if (found.item == no_index || !std::isfinite(found.squared_distance)) return result;
  const TrianglePoint point = on(found.item, p);
  result.triangle = found.item;
  result.position = point.position;
  result.weights = point.weights;
  result.distance = std::sqrt(found.squared_distance);
  return result;
}

Array<Box> boxes_of(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host) {
  Array<Box> boxes(triangles.size(), host.memory);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const Index v : triangles[t])
      boxes[t].add(positions[v]);
  }
  return boxes;
}

}  // namespace orbicube::mesh
