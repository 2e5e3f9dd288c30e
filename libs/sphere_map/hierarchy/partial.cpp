#include "sphere_map/hierarchy/partial.h"

#include <algorithm>

namespace orbicube::sphere_map {

void keep_partial(std::span<const Collapse> collapses, std::span<const Vector3> directions, Partial* partial) {
  if (partial == nullptr) return;
  const auto placed = static_cast<std::size_t>(std::count_if(
      directions.begin(), directions.end(), [](const Vector3& direction) { return direction != Vector3::Zero(); }));
  if (placed == 0 || placed < partial->placed) return;
  partial->placed = placed;
  partial->directions.assign(directions.begin(), directions.end());
  // The last collapse first, so that `kept` has a place, its own or another's.
  for (auto collapse = collapses.rbegin(); collapse != collapses.rend(); ++collapse) {
    Vector3& direction = partial->directions[collapse->removed];
    if (direction == Vector3::Zero()) direction = partial->directions[collapse->kept];
  }
}

}  // namespace orbicube::sphere_map
