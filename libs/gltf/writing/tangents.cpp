#include "gltf/writing/tangents.h"

#include <Eigen/Geometry>
#include <cstddef>

namespace orbicube::gltf {
namespace {

using mesh::Vector3;

// Twice the area of a triangle times the direction in which the first coordinate grows, and twice its area in the
// texture: positive where the texture is not mirrored.
struct Growth {
  Vector3 direction = Vector3::Zero();
  double area = 0;
};

Growth growth_of(const Vector3& ab, const Vector3& ac, const Eigen::Vector2d& st_ab, const Eigen::Vector2d& st_ac) {
  // v goes down.
  const double area = st_ac[0] * st_ab[1] - st_ab[0] * st_ac[1];
  Vector3 direction = (st_ab[1] * ac - st_ac[1] * ab) * (area < 0 ? -1 : 1);
  direction.stableNormalize();
  return {ab.cross(ac).norm() * direction, area};
}

}  // namespace

base::Array<float> smooth_tangents(std::span<const float> positions, std::span<const float> normals,
                                   std::span<const float> coordinates, std::span<const mesh::Triangle> triangles,
                                   const base::Host& host) {
  const auto vector = [](std::span<const float> values, std::size_t v) -> Vector3 {
    return Eigen::Map<const Eigen::Vector3f>(values.data() + 3 * v).cast<double>();
  };
  const auto coordinate = [&](std::size_t v) -> Eigen::Vector2d {
    return Eigen::Map<const Eigen::Vector2f>(coordinates.data() + 2 * v).cast<double>();
  };
  base::Array<Growth> sums(positions.size() / 3, Growth(), host.memory);
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i % base::items_between_reports == 0) host.report("making tangents", i, triangles.size());
    const auto& [a, b, c] = triangles[i];
    const Growth growth =
        growth_of(vector(positions, b) - vector(positions, a), vector(positions, c) - vector(positions, a),
                  coordinate(b) - coordinate(a), coordinate(c) - coordinate(a));
    for (const mesh::Index v : triangles[i]) {
      sums[v].direction += growth.direction;
      sums[v].area += growth.area;
    }
  }
  base::Array<float> tangents(4 * sums.size(), host.memory);
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (v % base::items_between_reports == 0) host.report("making tangents", v, sums.size());
    const Vector3 normal = vector(normals, v);
    Vector3 tangent = sums[v].direction - sums[v].direction.dot(normal) * normal;
    tangent.stableNormalize();
    if (!(tangent.squaredNorm() > 0.5)) tangent = normal.unitOrthogonal();
    Eigen::Map<Eigen::Vector3f>(tangents.data() + 4 * v) = tangent.cast<float>();
    tangents[4 * v + 3] = sums[v].area < 0 ? -1.0F : 1.0F;
  }
  return tangents;
}

}  // namespace orbicube::gltf
