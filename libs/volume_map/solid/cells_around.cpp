#include "volume_map/solid/cells_around.h"

namespace orbicube::volume_map {

void CellsAround::gather(std::span<const Index> corners, std::size_t each) {
  for (const Index v : corners)
    ++begin_[v + 1];
  for (std::size_t v = 0; v + 1 < begin_.size(); ++v)
    begin_[v + 1] += begin_[v];
  // From the end, so that each end moves down to its begin.
  for (std::size_t i = corners.size(); i-- > 0;)
    cells_[--begin_[corners[i] + 1]] = static_cast<Index>(i / each);
  // What each vertex has stands one place too far.
  for (std::size_t v = 0; v + 1 < begin_.size(); ++v)
    begin_[v] = begin_[v + 1];
  begin_.back() = static_cast<Index>(corners.size());
}

}  // namespace orbicube::volume_map
