#include "hexmesh/grid/even_lengths.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "polycube/map/certificate.h"

namespace orbicube::hexmesh {
namespace {

using polycube::SurfaceMap;

// Where an axis is cut, ascending: at the planes of the polycube's patches, and between two of them at equal distances.
Array<double> cuts_of(const SurfaceMap& map, int axis, int parts, std::pmr::memory_resource* memory) {
  Array<double> planes(memory);
  for (std::size_t i = 0; i < map.triangles.size(); ++i) {
    if (polycube::axis_of(map.labels[i]) == axis) planes.push_back(map.polycube[map.triangles[i][0]][axis]);
  }
  std::sort(planes.begin(), planes.end());
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  Array<double> cuts(memory);
  for (std::size_t i = 0; i + 1 < planes.size(); ++i) {
    for (int k = 0; k < parts; ++k)
      cuts.push_back(planes[i] + (planes[i + 1] - planes[i]) * k / parts);
  }
  cuts.push_back(planes.back());
  return cuts;
}

// The interval between cuts that a coordinate lies in; those outside of all count to the first or the last.
std::size_t interval_of(std::span<const double> cuts, double x) {
  const auto above = std::upper_bound(cuts.begin(), cuts.end(), x) - cuts.begin();
  return static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(cuts) - 2));
}

// How long the polycube's direction along the axis is in space, in each interval: a mean over the areas on the
// polycube that counts the longest most.
Array<double> stretches_of(const SurfaceMap& map, int axis, std::span<const double> cuts,
                           std::pmr::memory_resource* memory) {
  constexpr double power = 8, most = 8;
  Array<double> sum(cuts.size() - 1, 0, memory), area(sum.size(), 0, memory);
  for (std::size_t i = 0; i < map.triangles.size(); ++i) {
    const int normal = polycube::axis_of(map.labels[i]);
    if (normal == axis) continue;
    const int other = polycube::third_axis(axis, normal);
    const mesh::Triangle& t = map.triangles[i];
    const Vector3 a = map.polycube[t[1]] - map.polycube[t[0]], b = map.polycube[t[2]] - map.polycube[t[0]];
    const double twice_area = a[axis] * b[other] - a[other] * b[axis];
    if (twice_area == 0) continue;
    const Vector3 along = ((map.positions[t[1]] - map.positions[t[0]]) * b[other] -
                           (map.positions[t[2]] - map.positions[t[0]]) * a[other]) /
                          twice_area;
    const double center = (map.polycube[t[0]][axis] + map.polycube[t[1]][axis] + map.polycube[t[2]][axis]) / 3;
    const std::size_t k = interval_of(cuts, center);
    sum[k] += std::abs(twice_area) * std::pow(along.norm(), power);
    area[k] += std::abs(twice_area);
  }
  double all = 0, all_area = 0;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    all += sum[k];
    all_area += area[k];
  }
  const double mean = std::pow(all / all_area, 1 / power);
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] = area[k] > 0 ? std::clamp(std::pow(sum[k] / area[k], 1 / power), mean / most, mean * most) : mean;
  return sum;
}

SurfaceMap moved(const SurfaceMap& map, int parts, const base::Host& host) {
  SurfaceMap result(host.memory);
  result = map;
  for (int axis = 0; axis < 3; ++axis) {
    host.report("even", static_cast<std::uint64_t>(axis), 3);
    const Array<double> cuts = cuts_of(map, axis, parts, host.memory);
    const Array<double> stretches = stretches_of(map, axis, cuts, host.memory);
    Array<double> to(cuts.size(), cuts[0], host.memory);
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k)
      to[k + 1] = to[k] + (cuts[k + 1] - cuts[k]) * stretches[k];
    for (Vector3& p : result.polycube) {
      const std::size_t k = interval_of(cuts, p[axis]);
      // Exact at both ends: planes stay planes.
      const double part = (p[axis] - cuts[k]) / (cuts[k + 1] - cuts[k]);
      p[axis] = to[k] * (1 - part) + to[k + 1] * part;
    }
  }
  return result;
}

}  // namespace

SurfaceMap map_with_even_lengths(const SurfaceMap& map, const base::Host& host) {
  for (const int parts : {4, 1}) {
    SurfaceMap even = moved(map, parts, host);
    if (polycube::certify(even, host).valid()) return even;
  }
  SurfaceMap same(host.memory);
  same = map;
  return same;
}

}  // namespace orbicube::hexmesh
