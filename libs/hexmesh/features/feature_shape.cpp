#include "hexmesh/features/feature_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace orbicube::hexmesh {
namespace {

Array<Vector3> scaled(std::span<const Vector3> positions, double scale, std::pmr::memory_resource* memory) {
  Array<Vector3> result(positions.begin(), positions.end(), memory);
  for (Vector3& p : result)
    p *= scale;
  return result;
}

}  // namespace

FeatureShape::FeatureShape(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                           const mesh::FeatureGraph& graph, double scale, const base::Host& host)
    : graph_(graph),
      triangles_(triangles),
      positions_(scaled(positions, scale, host.memory)),
      along_(graph.vertices.size(), 0, host.memory),
      bends_(host.memory),
      bends_and_fades_(host.memory),
      by_patch_(
          graph.euler.size(),
          [&](const auto& visit) {
            for (std::size_t t = 0; t < triangles.size(); ++t)
              visit(graph.patches[t], triangles[t]);
          },
          host.memory),
      normals_(host.memory),
      whole_(positions_, triangles, host) {
  for (const mesh::Triangle& t : by_patch_.all()) {
    const Vector3 normal = (positions_[t[1]] - positions_[t[0]]).cross(positions_[t[2]] - positions_[t[0]]);
    normals_.push_back(normal.stableNormalized());
  }
  Array<std::uint8_t> bend(positions.size(), 0, host.memory), fade(positions.size(), 0, host.memory);
  for (const Index v : graph.bends)
    bend[v] = 1;
  for (const Index v : graph.fades)
    fade[v] = 1;
  for (const mesh::FeatureArc& arc : graph.arcs) {
    auto &bends = bends_.emplace_back(), &all = bends_and_fades_.emplace_back();
    for (Index i = arc.begin + 1; i < arc.end; ++i) {
      const Index v = graph.vertices[i];
      along_[i] = along_[i - 1] + (positions_[v] - positions_[graph.vertices[i - 1]]).norm();
      if (i + 1 == arc.end) continue;
      if (bend[v] != 0) bends.push_back(along_[i]);
      if (bend[v] != 0 || fade[v] != 0) all.push_back(along_[i]);
    }
  }
  for (std::size_t p = 0; p < graph.euler.size(); ++p)
    searches_.emplace_back(positions_, by_patch_[p], host);
}

bool FeatureShape::joined(Index corner, Index other, double length_limit) const {
  const auto ends = graph_.around[corner];
  return std::any_of(ends.begin(), ends.end(), [&](const mesh::FeatureEnd& end) {
    return other_corner(end) == other && length(end.arc) < length_limit;
  });
}

std::pair<Index, double> FeatureShape::segment(Index arc, double s) const {
  const mesh::FeatureArc& a = graph_.arcs[arc];
  Index i = a.begin + 1;
  while (i + 1 < a.end && along_[i] < s)
    ++i;
  const double span = along_[i] - along_[i - 1];
  return {i, span > 0 ? std::clamp((s - along_[i - 1]) / span, 0.0, 1.0) : 0};
}

Vector3 FeatureShape::point(Index arc, double s) const {
  const auto [i, t] = segment(arc, s);
  return (1 - t) * positions_[graph_.vertices[i - 1]] + t * positions_[graph_.vertices[i]];
}

double FeatureShape::turning(Index arc, double s, double window) const {
  const Vector3 middle = point(arc, s);
  const Vector3 before = middle - point(arc, s - window / 2), after = point(arc, s + window / 2) - middle;
  return std::atan2(before.cross(after).norm(), before.dot(after));
}

double FeatureShape::same_place(Index arc, double s, const FeatureShape& other) const {
  const auto [i, t] = segment(arc, s);
  return (1 - t) * other.along_[i - 1] + t * other.along_[i];
}

Vector3 FeatureShape::direction(const mesh::FeatureEnd& end) const {
  constexpr double far = 1.5;  // cells
  const double whole = length(end.arc), s = std::min(far, whole / 2);
  return (point(end.arc, end.end == 1 ? whole - s : s) - corner(graph_.arcs[end.arc].corners[end.end])).normalized();
}

FeatureShape::ArcPoint FeatureShape::nearest_on_arc(Index arc, const Vector3& p, double s, double reach) const {
  const mesh::FeatureArc& a = graph_.arcs[arc];
  double least = std::numeric_limits<double>::infinity();
  ArcPoint best;
  best.s = s;
  for (Index i = a.begin + 1; i < a.end; ++i) {
    if (along_[i] < s - reach || along_[i - 1] > s + reach) continue;
    const Vector3 &from = positions_[graph_.vertices[i - 1]], way = positions_[graph_.vertices[i]] - from;
    const double square = way.squaredNorm();
    const double t = square > 0 ? std::clamp(way.dot(p - from) / square, 0.0, 1.0) : 0;
    const Vector3 q = from + t * way;
    const double distance = (q - p).squaredNorm();
    if (distance >= least) continue;
    least = distance;
    best.s = along_[i - 1] + t * (along_[i] - along_[i - 1]);
    best.position = q;
    best.tangent = way;
  }
  best.distance = (best.position - p).norm();
  best.tangent.stableNormalize();
  return best;
}

FeatureShape::ArcPoint FeatureShape::nearest_on_arc(Index arc, const Vector3& p) const {
  return nearest_on_arc(arc, p, 0, std::numeric_limits<double>::infinity());
}

FeatureShape::PatchPoint FeatureShape::nearest_on_patch(Index patch, const Vector3& p, const Vector3& facing) const {
  constexpr double against = -0.2;  // cosine
  const Vector3* const normals = normals_.data() + by_patch_.begin(patch);
  mesh::SurfacePoint found = searches_[patch].nearest_of(p, [&](Index t) { return normals[t].dot(facing) > against; });
  if (found.triangle == no_index) found = searches_[patch].nearest(p);
  return {found.position, normals[found.triangle]};
}

Index FeatureShape::nearest_patch(const Vector3& p) const {
  return graph_.patches[whole_.nearest(p).triangle];
}

}  // namespace orbicube::hexmesh
