#include "polycube/map/distorted_regions.h"

#include <algorithm>

#include "polycube/surface/distortion.h"

namespace orbicube::polycube {
namespace {

constexpr double much = 2, min_area = 0.002;
constexpr int rings = 2;  // around what is distorted

// The change of angles times that of areas (distortion.h), a mean over each triangle of the surface.
Array<double> changes(const Surface& surface, const SurfaceMap& map, const base::Host& host) {
  constexpr double most = 100;
  Array<double> sum(surface.triangles.size(), 0, host.memory), area(sum, host.memory);
  const TriangleMeasure measure(map);
  double whole = 0, whole_on_polycube = 0;
  for (const Triangle& t : map.triangles) {
    const TriangleChange change = measure(t);
    whole += change.area;
    whole_on_polycube += change.area_on_polycube;
  }
  for (std::size_t i = 0; i < map.triangles.size(); ++i) {
    const TriangleChange change = measure(map.triangles[i]);
    if (change.angle == 0) continue;
    const double ratio = change.area_on_polycube / change.area * (whole / whole_on_polycube);
    sum[map.triangle_sources[i]] += change.area * std::min(most, 0.5 * change.angle * (ratio + 1 / ratio));
    area[map.triangle_sources[i]] += change.area;
  }
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] = area[i] > 0 ? sum[i] / area[i] : 1;
  return sum;
}

// Connected sets of triangles for which `inside` holds: of each its number, and their areas.
template <class Inside>
Array<double> components(const Surface& surface, const Inside& inside, Array<Index>& of_triangle) {
  auto* const memory = of_triangle.get_allocator().resource();
  Array<double> areas(memory);
  Array<Index> queue(memory);
  of_triangle.assign(surface.triangles.size(), no_index);
  for (Index first = 0; first < surface.triangles.size(); ++first) {
    if (of_triangle[first] != no_index || !inside(first)) continue;
    const auto number = static_cast<Index>(areas.size());
    areas.push_back(0);
    queue.assign(1, first);
    of_triangle[first] = number;
    for (std::size_t k = 0; k < queue.size(); ++k) {
      areas[number] += surface.areas[queue[k]];
      for (Index h = 3 * queue[k]; h < 3 * queue[k] + 3; ++h) {
        const Index other = surface.neighbor(h);
        if (of_triangle[other] != no_index || !inside(other)) continue;
        of_triangle[other] = number;
        queue.push_back(other);
      }
    }
  }
  return areas;
}

}  // namespace

DistortedRegions find_distorted_regions(const Surface& surface, const SurfaceMap& map, const base::Host& host) {
  const Array<double> change = changes(surface, map, host);
  Array<std::uint8_t> chosen(surface.triangles.size(), 0, host.memory);
  for (Index i = 0; i < chosen.size(); ++i)
    chosen[i] = change[i] >= much;
  for (int k = 0; k < rings; ++k) {
    const Array<std::uint8_t> before(chosen, host.memory);
    for (Index h = 0; h < 3 * chosen.size(); ++h)
      chosen[h / 3] |= before[surface.neighbor(h)];
  }
  // All that is left but the largest part is enclosed: tips of protrusions lie well on a face.
  Array<Index> number(host.memory);
  const Array<double> rest = components(
      surface, [&](Index i) { return chosen[i] == 0; }, number);
  const auto largest = static_cast<Index>(std::max_element(rest.begin(), rest.end()) - rest.begin());
  for (Index i = 0; i < chosen.size(); ++i)
    chosen[i] |= number[i] != no_index && number[i] != largest;

  DistortedRegions result(host.memory);
  const Array<double> areas = components(
      surface, [&](Index i) { return chosen[i] != 0; }, number);
  Array<Index> order(host.memory);
  for (Index r = 0; r < areas.size(); ++r) {
    if (areas[r] >= min_area * surface.area) order.push_back(r);
  }
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return areas[a] > areas[b]; });
  result.count = order.size();
  result.of_triangle.assign(chosen.size(), no_index);
  Array<Index> place(areas.size(), no_index, host.memory);
  for (Index k = 0; k < order.size(); ++k)
    place[order[k]] = k;
  for (Index i = 0; i < chosen.size(); ++i) {
    if (number[i] != no_index) result.of_triangle[i] = place[number[i]];
  }
  return result;
}

}  // namespace orbicube::polycube
