// Sets of unit squares of a grid, as rectangles.
#pragma once

#include <array>
#include <span>

#include "base/array.h"

namespace orbicube::polycube {

// Rows [low[0], high[0]) and columns [low[1], high[1]).
struct GridRectangle {
  std::array<int, 2> low, high;
};

// Cuts a set of squares {row, column}, sorted, into slabs: the runs of each row, and equal runs of consecutive rows
// together. Appends them to `slabs`. O(n) and more where rows have many runs.
void cut_into_slabs(std::span<const std::array<int, 2>> squares, base::Array<GridRectangle>& slabs);

}  // namespace orbicube::polycube
