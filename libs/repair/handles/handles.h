// Small handles and tunnels cut: the surface is cut along a loop that does not separate it, and both sides are closed.
#pragma once

#include <cstdint>

#include "repair/types.h"

namespace orbicube::repair {

struct HandleOptions {
  std::int64_t max_genus =
      -1;                 // handles are cut, shortest loops first, down to this sum over all parts; negative: no limit
  double max_length = 0;  // of the loop of a handle to cut; 0: no limit, if max_genus is set
};

struct HandleFigures {
  std::size_t cut = 0;
  std::size_t triangles = 0;  // added
  double longest = 0;         // loop that was cut
  double largest_move = 0;    // of a vertex of a loop
};

// Cuts handles of a closed, oriented, manifold surface; does nothing unless an option requests it. The vertices of a
// loop become two, each of which moves toward the neighbors on its side, so that both patches are apart. A loop around
// a handle cuts it off, one through a tunnel closes it. Each takes O(n) and the searches of shortest_loop. Throws Error
// "non-manifold-edge" and similar for other surfaces, "cancelled".
HandleFigures cut_handles(Soup& soup, const HandleOptions& options, const Context& context);

}  // namespace orbicube::repair
