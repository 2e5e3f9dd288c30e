#include "gltf/writing/normals.h"

#include <Eigen/Geometry>
#include <cstddef>

namespace orbicube::gltf {

base::Array<float> smooth_normals(std::span<const float> positions, std::span<const mesh::Triangle> triangles,
                                  const base::Host& host) {
  using mesh::Vector3;
  const auto position = [&](mesh::Index v) -> Vector3 {
    return Eigen::Map<const Eigen::Vector3f>(positions.data() + std::size_t{3} * v).cast<double>();
  };
  base::Array<Vector3> sums(positions.size() / 3, Vector3::Zero(), host.memory);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i % base::items_between_reports == 0) host.report("making normals", i, triangles.size());
    const mesh::Triangle& t = triangles[i];
    const Vector3 twice_area = (position(t[1]) - position(t[0])).cross(position(t[2]) - position(t[0]));
    for (const mesh::Index v : t)
      sums[v] += twice_area;
  }
  base::Array<float> normals(positions.size(), host.memory);
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (v % base::items_between_reports == 0) host.report("making normals", v, sums.size());
    // stableNormalize: the square of the area of a tiny triangle is zero.
    Vector3 normal = sums[v];
    normal.stableNormalize();
    if (!(normal.squaredNorm() > 0.5)) normal = Vector3::UnitZ();
    Eigen::Map<Eigen::Vector3f>(normals.data() + 3 * v) = normal.cast<float>();
  }
  return normals;
}

}  // namespace orbicube::gltf
