// The cells around each vertex.
#pragma once

#include <array>
#include <span>

#include "volume_map/untangle/variables.h"

namespace orbicube::volume_map {

class CellsAround {
 public:
  // Of hexahedra, tetrahedra or triangles. Keeps no view.
  template <std::size_t corners>
  CellsAround(std::span<const std::array<Index, corners>> cells, std::size_t vertices,
              std::pmr::memory_resource* memory)
      : begin_(vertices + 1, 0, memory), cells_(corners * cells.size(), memory) {
    if (!cells.empty()) gather({cells.front().data(), cells_.size()}, corners);
  }

  // In ascending order.
  std::span<const Index> of(Index vertex) const {
    return std::span(cells_).subspan(begin_[vertex], begin_[vertex + 1] - begin_[vertex]);
  }

 private:
  // Corners of all cells, a fixed number each.
  void gather(std::span<const Index> corners, std::size_t each);

  Array<Index> begin_, cells_;
};

}  // namespace orbicube::volume_map
