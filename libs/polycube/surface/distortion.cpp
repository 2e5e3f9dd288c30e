#include "polycube/surface/distortion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "mesh/search/unit_scale.h"
#include "mesh/topology/degenerate_triangles.h"

namespace orbicube::polycube {

namespace {

std::array<Vector3, 3> corners(std::span<const Vector3> p, const Triangle& t, double scale) {
  return {p[t[0]] * scale, p[t[1]] * scale, p[t[2]] * scale};
}

double area_of(const std::array<Vector3, 3>& p) {
  return 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
}

// 1 where lengths and areas are in the middle of the range of double.
double scale_for(std::span<const Vector3> positions, std::span<const Triangle> triangles) {
  constexpr int far = 100;
  const int exponent = mesh::unit_scale_exponent(positions, triangles);
  return std::abs(exponent) <= far ? 1 : std::ldexp(1.0, std::clamp(exponent, -1022, 1023));
}

}  // namespace

double rounding_of_input(const SurfaceMap& map) {
  std::size_t given = map.positions.size();
  while (given > 0 && given <= map.vertex_sources.size() && map.vertex_sources[given - 1].corner[1] != no_index)
    --given;
  return mesh::rounding_unit(std::span(map.positions).first(given));
}

TriangleMeasure::TriangleMeasure(const SurfaceMap& map)
    : map_(map),
      scale_in_space_(scale_for(map.positions, map.triangles)),
      scale_on_polycube_(scale_for(map.polycube, map.triangles)),
      rounding_(rounding_of_input(map)) {}

TriangleChange TriangleMeasure::operator()(const Triangle& t) const {
  const auto p = corners(map_.positions, t, scale_in_space_), q = corners(map_.polycube, t, scale_on_polycube_);
  if (mesh::is_degenerate(p[0], p[1], p[2], rounding_)) return {0, 0, 0};
  TriangleChange result{area_of(p), area_of(q), 0};
  if (!(result.area > 0) || !(result.area_on_polycube > 0)) return result;
  double sum = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    const double cotangent = (p[b] - p[a]).dot(p[c] - p[a]) / (2 * result.area);
    sum += cotangent * (q[b] - q[c]).squaredNorm();
  }
  result.angle = sum / (4 * result.area_on_polycube);
  return result;
}

Distortion measure_distortion(const SurfaceMap& map, const base::Host& host) {
  host.report("distortion", 0, 0);
  const TriangleMeasure measure(map);
  Array<TriangleChange> changes(host.memory);
  changes.reserve(map.triangles.size());
  double area = 0, area_on_polycube = 0;
  for (const Triangle& t : map.triangles) {
    changes.push_back(measure(t));
    area += changes.back().area;
    area_on_polycube += changes.back().area_on_polycube;
  }
  Distortion result;
  double count = 0, weight = 0;
  for (const auto& [in_space, on_polycube, angle] : changes) {
    if (angle == 0) {
      ++result.left_out;
      continue;
    }
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
