#include "mesh/search/placing.h"

#include <Eigen/Geometry>

#include "mesh/search/measures.h"

namespace orbicube::mesh {

Placing placing_of(std::span<const Vector3> positions, std::span<const Triangle> triangles) {
  Placing result;
  if (triangles.empty()) return result;
  Vector3 low = positions[triangles[0][0]];
  Vector3 high = low;
  for (const Triangle& t : triangles) {
    for (const Index v : t) {
      low = low.cwiseMin(positions[v]);
      high = high.cwiseMax(positions[v]);
    }
  }
  // Halves, since the whole extent can overflow; divided twice, since the diagonal can as well.
  result.centre = 0.5 * low + 0.5 * high;
  const Vector3 half_extent = 0.5 * high - 0.5 * low;
  result.half_size = half_extent.maxCoeff();
  if (result.half_size > 0) result.diagonal = 2 * (half_extent / result.half_size).norm();
  return result;
}

Vector3 Placing::direction(const Vector3& p) const {
  const Vector3 away = 0.25 * p - 0.25 * centre;  // the whole, and its length, can overflow
  return away != Vector3::Zero() ? Vector3(away.stableNormalized()) : Vector3(Vector3::UnitZ());
}

Array<Vector3> normalized(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                          std::pmr::memory_resource* memory) {
  Array<Vector3> result(positions.size(), Vector3::Zero(), memory);
  const Placing place = placing_of(positions, triangles);
  if (!(place.half_size > 0)) return result;
  const Array<std::uint8_t> used = used_vertices(positions.size(), triangles, memory);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (used[i] != 0) result[i] = place(positions[i]);
  }
  return result;
}

}  // namespace orbicube::mesh
