#include "polycube/surface/surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace orbicube::polycube {

Surface::Surface(Array<Vector3> vertex_positions, Array<Triangle> faces, const base::Host& host)
    : positions(std::move(vertex_positions)),
      triangles(std::move(faces)),
      connectivity(positions.size(), triangles, host),
      normals(unit_normals(positions, triangles, host)),
      areas(triangles.size(), host.memory) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    areas[i] = 0.5 * (positions[b] - positions[a]).cross(positions[c] - positions[a]).norm();
    area += areas[i];
  }
}

Array<Vector3> unit_normals(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                            const base::Host& host) {
  Array<Vector3> result(triangles.size(), host.memory);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    const Vector3 normal = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
    const double length = normal.norm();
    result[i] = length > 0 ? Vector3(normal / length) : Vector3::UnitZ();
  }
  return result;
}

double cotangent(const Vector3& a, const Vector3& b, const Vector3& c) {
  constexpr double min_sine = 1e-12;
  const Vector3 u = b - a, v = c - a;
  const double lengths = u.norm() * v.norm();
  if (!(lengths > 0)) return 0;
  return u.dot(v) / std::max(u.cross(v).norm(), min_sine * lengths);
}

}  // namespace orbicube::polycube
