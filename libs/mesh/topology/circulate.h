// The walk around a vertex by half-edges, whatever stores them.
#pragma once

#include "mesh/mesh.h"

namespace orbicube::mesh {

// Calls visit(half_edge) for `first` and each half-edge that turn(half_edge) leads to, until it is `first` again or
// no_index. Nothing for no_index.
template <class Turn, class Visit>
void circulate(Index first, const Turn& turn, const Visit& visit) {
  if (first == no_index) return;
  Index h = first;
  do {
    visit(h);
    h = turn(h);
  } while (h != first && h != no_index);
}

}  // namespace orbicube::mesh
