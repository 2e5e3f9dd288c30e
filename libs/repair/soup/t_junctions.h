// T-junctions: vertices of the boundary that lie on another edge of the boundary split it.
#pragma once

#include "repair/types.h"

namespace orbicube::repair {

struct TJunctionFigures {
  std::size_t splits = 0;   // of an edge at a vertex
  double largest_move = 0;  // distance of such a vertex from its edge
};

// Splits each edge with one face at the vertices of other such edges that are at most `distance` away from it, and
// farther than that from its ends; the face is cut into triangles. O(n + k log k) for k boundary edges. Throws Error
// "cancelled".
TJunctionFigures split_t_junctions(Soup& soup, double distance, const Context& context);

}  // namespace orbicube::repair
