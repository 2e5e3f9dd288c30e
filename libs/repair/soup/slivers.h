// Near-degenerate triangles removed: needles by the collapse of their shortest edge, caps by the flip of their longest
// one (Botsch and Kobbelt 2001, "A robust procedure to eliminate degenerate faces from triangle meshes").
#pragma once

#include "repair/types.h"

namespace orbicube::repair {

struct SliverFigures {
  std::size_t found = 0;
  std::size_t collapsed = 0;  // edges
  std::size_t flipped = 0;    // edges
  std::size_t removed = 0;    // triangles whose longest edge is on the boundary
  std::size_t left = 0;       // that cannot be removed within the bound
  double largest_move = 0;    // sums of steps at one place
};

// Triangles of the height `ratio` times their longest side and less, and those that are degenerate by the rounding of
// their coordinates, are collapsed or flipped where the surface moves by at most `max_move` in all, stays as manifold
// as it is and no other triangle becomes degenerate or turns by 90 degrees. Triangles that are not near a
// near-degenerate one stay. O(n) besides what is changed. No triangle may have a repeated corner. Throws Error
// "cancelled".
SliverFigures remove_slivers(Soup& soup, double ratio, double max_move, const Context& context);

// Returns the number of such triangles.
std::size_t count_slivers(const Soup& soup, double ratio);

}  // namespace orbicube::repair
