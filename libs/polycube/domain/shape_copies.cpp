#include "polycube/domain/shape_copies.h"

#include <algorithm>
#include <cmath>

#include "mesh/search/placing.h"
#include "mesh/search/rotations.h"

namespace orbicube::polycube {
namespace {

// Vertices of triangles.
Array<Index> used_by(std::span<const Triangle> triangles, const base::Host& host) {
  Array<Index> result(host.memory);
  for (const Triangle& t : triangles)
    result.insert(result.end(), t.begin(), t.end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

bool is_copy(const SurfaceSpan& first, const SurfaceSpan& second, const base::Host& host) {
  constexpr double tolerance = 1e-6;  // what float32 keeps of coordinates, with a margin
  if (first.positions.size() != second.positions.size() ||
      !std::equal(first.triangles.begin(), first.triangles.end(), second.triangles.begin(), second.triangles.end()))
    return false;
  const Array<Vector3> a = mesh::normalized(first.positions, first.triangles, host.memory);
  const Array<Vector3> b = mesh::normalized(second.positions, second.triangles, host.memory);
  const Array<Index> used = used_by(first.triangles, host);
  Vector3 mean_a = Vector3::Zero(), mean_b = Vector3::Zero();
  for (const Index v : used) {
    mean_a += a[v] / static_cast<double>(used.size());
    mean_b += b[v] / static_cast<double>(used.size());
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double spread_a = 0, spread_b = 0;
  for (const Index v : used) {
    covariance += (b[v] - mean_b) * (a[v] - mean_a).transpose();
    spread_a += (a[v] - mean_a).squaredNorm();
    spread_b += (b[v] - mean_b).squaredNorm();
  }
  if (!(spread_a > 0) || !(spread_b > 0)) return false;
  const Eigen::Matrix3d linear = std::sqrt(spread_b / spread_a) * mesh::nearest_rotation(covariance);
  return std::all_of(used.begin(), used.end(),
                     [&](Index v) { return (linear * (a[v] - mean_a) - (b[v] - mean_b)).norm() <= tolerance; });
}

}  // namespace

std::vector<std::size_t> originals_of(std::span<const SurfaceSpan> shapes, const base::Host& host) {
  std::vector<std::size_t> result(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    result[i] = i;
    for (std::size_t k = 0; k < i && result[i] == i; ++k)
      if (result[k] == k && is_copy(shapes[k], shapes[i], host)) result[i] = k;
  }
  return result;
}

void put_onto(SurfaceMap& map, std::span<const Vector3> positions) {
  for (std::size_t v = 0; v < map.positions.size(); ++v) {
    const VertexSource& source = map.vertex_sources[v];
    if (source.corner[1] == no_index) {
      map.positions[v] = positions[source.corner[0]];
      continue;
    }
    map.positions[v].setZero();
    for (std::size_t k = 0; k < 3; ++k) {
      if (source.corner[k] != no_index) map.positions[v] += source.weight[k] * positions[source.corner[k]];
    }
  }
}

SurfaceMap map_of_copy(const SurfaceMap& map, std::span<const Vector3> positions, const base::Host& host) {
  SurfaceMap result(host.memory);
  result = map;
  put_onto(result, positions);
  return result;
}

}  // namespace orbicube::polycube
