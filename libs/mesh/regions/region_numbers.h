// The numbers of the regions of a mesh.
#pragma once

#include <algorithm>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// No numbers instead of none but 0.
inline void clear_if_zero(Array<std::int32_t>& regions) {
  if (std::ranges::all_of(regions, [](std::int32_t region) { return region == 0; })) regions.clear();
}

// Returns the different numbers in ascending order, without 0, which is no region. O(n log n).
inline Array<std::int32_t> distinct_regions(std::span<const std::int32_t> regions, std::pmr::memory_resource* memory) {
  Array<std::int32_t> result(memory);
  for (const std::int32_t region : regions) {
    if (region != 0 && (result.empty() || result.back() != region)) result.push_back(region);
  }
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace orbicube::mesh
