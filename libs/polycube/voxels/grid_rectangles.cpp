#include "polycube/voxels/grid_rectangles.h"

#include <algorithm>

namespace orbicube::polycube {

void cut_into_slabs(std::span<const std::array<int, 2>> squares, base::Array<GridRectangle>& slabs) {
  // Slabs that end at the row before: open_begin .. row_begin of `slabs`, in the order of their columns.
  std::size_t open_begin = slabs.size();
  for (std::size_t i = 0; i < squares.size();) {
    const int row = squares[i][0];
    const std::size_t row_begin = slabs.size();
    for (; i < squares.size() && squares[i][0] == row;) {
      std::size_t last = i;
      while (last + 1 < squares.size() && squares[last + 1][0] == row && squares[last + 1][1] == squares[last][1] + 1)
        ++last;
      GridRectangle run{{row, squares[i][1]}, {row + 1, squares[last][1] + 1}};
      for (std::size_t k = open_begin; k < row_begin; ++k) {
        GridRectangle& open = slabs[k];
        if (open.high[0] != row || open.low[1] != run.low[1] || open.high[1] != run.high[1]) continue;
        run.low[0] = open.low[0];
        open.high[0] = open.low[0];  // goes on in the new one
        break;
      }
      slabs.push_back(run);
      i = last + 1;
    }
    open_begin = row_begin;
  }
  std::erase_if(slabs, [](const GridRectangle& r) { return r.low[0] == r.high[0]; });
}

}  // namespace orbicube::polycube
