#include "polycube/distortion.h"

#include <Eigen/Geometry>

namespace orbicube::polycube {

namespace {

double area_of(std::span<const Vector3> p, const Triangle& t) {
  return 0.5 * (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).norm();
}

}  // namespace

TriangleChange measure_triangle(const SurfaceMap& map, const Triangle& t) {
  TriangleChange result{area_of(map.positions, t), area_of(map.polycube, t), 0};
  if (!(result.area > 0) || !(result.area_on_polycube > 0)) return result;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Index a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    const double cotangent =
        (map.positions[b] - map.positions[a]).dot(map.positions[c] - map.positions[a]) / (2 * result.area);
    sum += cotangent * (map.polycube[b] - map.polycube[c]).squaredNorm();
  }
  result.angle = sum / (4 * result.area_on_polycube);
  return result;
}

Distortion measure_distortion(const SurfaceMap& map, const base::Host& host) {
  host.report("distortion", 0, 0);
  double area = 0, area_on_polycube = 0;
  for (const Triangle& t : map.triangles) {
    area += area_of(map.positions, t);
    area_on_polycube += area_of(map.polycube, t);
  }
  Distortion result;
  double count = 0, weight = 0;
  for (const Triangle& t : map.triangles) {
    const auto [in_space, on_polycube, angle] = measure_triangle(map, t);
    if (angle == 0) continue;
    const double ratio = on_polycube / in_space * (area / area_on_polycube);
    const double change = 0.5 * (ratio + 1 / ratio);
    result.angle_mean += angle;
    result.area_mean += change;
    result.angle_weighted_mean += in_space * angle;
    result.area_weighted_mean += in_space * change;
    count += 1;
    weight += in_space;
  }
  if (count > 0) {
    result.angle_mean /= count;
    result.area_mean /= count;
    result.angle_weighted_mean /= weight;
    result.area_weighted_mean /= weight;
  }
  return result;
}

}  // namespace orbicube::polycube
