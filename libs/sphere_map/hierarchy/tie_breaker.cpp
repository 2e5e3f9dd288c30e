#include "sphere_map/hierarchy/tie_breaker.h"

#include <Eigen/Geometry>
#include <cmath>

namespace orbicube::sphere_map {
namespace {

// Change of a cost over the radius of gyration. Smaller: on flat regions of fine meshes, where costs are
// small differences, rounding decides again; larger: it competes with the costs themselves.
constexpr double amplitude = 0.005;

// Moments of third order below this, in units of the radius of gyration, are those of rounding.
constexpr double negligible = 1e-6;

// Calls visit(vertex, area of its triangles).
template <class Visit>
void for_each_area(std::span<const Vector3> positions, const VertexRings& rings, const base::Host& host,
                   const Visit& visit) {
  for (Index v = 0; v < rings.vertex_count(); ++v) {
    if (v % 65536 == 0) host.report("decimation", 0, 0);
    const auto ring = rings[v];
    double area = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vector3 to_next = positions[ring[i + 1 < ring.size() ? i + 1 : 0]] - positions[v];
      area += 0.5 * (positions[ring[i]] - positions[v]).cross(to_next).norm();
    }
    visit(v, area);
  }
}

Vector3 unit_or_zero(const Vector3& x) {
  const double length = x.norm();
  return length > negligible ? Vector3(x / length) : Vector3::Zero();
}

}  // namespace

TieBreaker::TieBreaker(std::span<const Vector3> positions, const VertexRings& rings, const base::Host& host) {
  double total = 0;
  for_each_area(positions, rings, host, [&](Index v, double area) {
    total += area;
    centroid_ += area * positions[v];
  });
  if (!(total > 0)) return;
  centroid_ /= total;

  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  Vector3 third = Vector3::Zero();
  for_each_area(positions, rings, host, [&](Index v, double area) {
    const Vector3 x = positions[v] - centroid_;
    second += area * x * x.transpose();
    third += area * x.squaredNorm() * x;
  });
  const double square = second.trace() / total;  // of the radius of gyration
  if (!(square > 0)) return;
  // These three turn with the surface. The third is a vector product, so that mirror images differ.
  const Vector3 first_axis = unit_or_zero(third / (total * square * std::sqrt(square)));
  const Vector3 image = second * first_axis / (total * square);
  const Vector3 second_axis = unit_or_zero(image - image.dot(first_axis) * first_axis);
  const Vector3 third_axis = first_axis.cross(second_axis);
  slope_ = amplitude / std::sqrt(square) * (0.61 * first_axis + 0.43 * second_axis + 0.29 * third_axis);
  curvature_ = amplitude / square * 0.37;
}

}  // namespace orbicube::sphere_map
