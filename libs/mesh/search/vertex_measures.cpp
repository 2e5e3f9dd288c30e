#include "mesh/search/vertex_measures.h"

#include <Eigen/Geometry>
#include <cmath>
#include <string>

#include "base/error.h"
#include "mesh/search/placing.h"

namespace orbicube::mesh {

Array<Vector3> vertex_normals(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                              const base::Host& host) {
  const Array<Vector3> x = normalized(positions, triangles, host.memory);
  Array<Vector3> normals(positions.size(), Vector3::Zero(), host.memory);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (t % 65536 == 0) host.report("normals", t, triangles.size());
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3& p = x[triangles[t][k]];
      const Vector3 e = x[triangles[t][(k + 1) % 3]] - p;
      const Vector3 f = x[triangles[t][(k + 2) % 3]] - p;
      const Vector3 normal = e.cross(f);
      const double size = normal.stableNorm();
      if (size > 0) normals[triangles[t][k]] += std::atan2(size, e.dot(f)) / size * normal;
    }
  }
  for (Vector3& n : normals) {
    const double length = n.norm();
    n = length > 0 ? Vector3(n / length) : Vector3(Vector3::UnitZ());
  }
  return normals;
}

Array<double> vertex_areas(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const base::Host& host) {
  Array<double> areas(positions.size(), 0.0, host.memory);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Triangle& triangle = triangles[t];
    for (const Index v : triangle) {
      if (v >= positions.size())
        throw base::Error("index-range", "triangle " + std::to_string(t) + " has vertex " + std::to_string(v) + " of " +
                                             std::to_string(positions.size()));
    }
    const Vector3 a = positions[triangle[1]] - positions[triangle[0]],
                  b = positions[triangle[2]] - positions[triangle[0]];
    const double third = a.cross(b).norm() / 6;
    for (const Index v : triangle)
      areas[v] += third;
  }
  return areas;
}

}  // namespace orbicube::mesh
