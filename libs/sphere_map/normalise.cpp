#include "sphere_map/normalise.h"

namespace orbicube::sphere_map {

Array<Vector3> normalised(std::span<const Vector3> positions, std::pmr::memory_resource* memory) {
  Array<Vector3> result(positions.size(), Vector3::Zero(), memory);
  if (positions.empty()) return result;
  Vector3 low = positions[0];
  Vector3 high = positions[0];
  for (const Vector3& p : positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  // Halves, since the whole extent can overflow; divided twice, since the diagonal can as well.
  const Vector3 centre = 0.5 * low + 0.5 * high;
  const Vector3 half_extent = 0.5 * high - 0.5 * low;
  const double largest = half_extent.maxCoeff();
  if (!(largest > 0)) return result;
  const double diagonal = 2 * (half_extent / largest).norm();
  for (std::size_t i = 0; i < positions.size(); ++i)
    result[i] = (positions[i] - centre) / largest / diagonal;
  return result;
}

}  // namespace orbicube::sphere_map
