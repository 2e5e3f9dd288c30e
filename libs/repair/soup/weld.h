// Vertices of open edges that stand at one place, or within a distance, become one.
#pragma once

#include "repair/types.h"

namespace orbicube::repair {

struct WeldFigures {
  std::size_t vertices = 0;   // welded to another
  std::size_t triangles = 0;  // that lost an edge by it, and are gone
  double largest_move = 0;    // of a vertex
};

// Welds vertices of edges with an odd number of faces to the first such vertex that is at most `distance` away; 0: at
// the same position. Vertices inside the surface stay: two parts that touch there are not joined. Returns zeros, and
// changes nothing, where no such vertex is near another. O(n log n). Throws Error "cancelled".
WeldFigures weld_open_edges(Soup& soup, double distance, const Context& context);

// Returns whether an edge has one face, or another odd number.
bool has_open_edges(const Soup& soup, const base::Host& host);

}  // namespace orbicube::repair
