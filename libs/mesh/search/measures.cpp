#include "mesh/search/measures.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace orbicube::mesh {

Array<std::uint8_t> used_vertices(std::size_t vertex_count, std::span<const Triangle> triangles,
                                  std::pmr::memory_resource* memory) {
  Array<std::uint8_t> used(vertex_count, 0, memory);
  for (const Triangle& t : triangles) {
    for (const Index v : t) {
      if (v < vertex_count) used[v] = 1;
    }
  }
  return used;
}

namespace {

// value * factor^count; what is too small for double keeps its sign.
double times(double value, double factor, int count) {
  double result = value;
  for (int i = 0; i < count; ++i)
    result *= factor;
  return result == 0 && value != 0 ? std::copysign(std::numeric_limits<double>::denorm_min(), value) : result;
}

}  // namespace

Measures measures(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host) {
  constexpr std::size_t triangles_between_reports = 65536;
  Measures result;
  if (triangles.empty()) return result;
  result.low = result.high = positions[triangles[0][0]];
  for (const Triangle& t : triangles) {
    for (const Index v : t) {
      result.low = result.low.cwiseMin(positions[v]);
      result.high = result.high.cwiseMax(positions[v]);
    }
  }
  const Vector3 centre = 0.5 * result.low + 0.5 * result.high;
  const double half = (0.5 * result.high - 0.5 * result.low).maxCoeff();
  if (half == 0) return result;
  double twice_area = 0;
  double six_volumes = 0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i % triangles_between_reports == 0) host.report("measuring", i, triangles.size());
    const auto unit = [&](std::size_t k) -> Vector3 { return (positions[triangles[i][k]] - centre) / half; };
    const Vector3 p = unit(0), q = unit(1), r = unit(2);
    twice_area += (q - p).cross(r - p).norm();
    six_volumes += p.dot(q.cross(r));
  }
  result.area = times(0.5 * twice_area, half, 2);
  result.volume = times(six_volumes / 6, half, 3);
  return result;
}

}  // namespace orbicube::mesh
