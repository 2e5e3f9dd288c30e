// Loops of boundary edges.
#pragma once

#include <span>

#include "repair/types.h"

namespace orbicube::repair {

// The half-edges of the faces that the boundary has, loop after loop: each one starts where the one before it ends,
// and no loop passes a vertex twice.
struct BoundaryLoops {
  explicit BoundaryLoops(std::pmr::memory_resource* memory) : half_edges(memory), begin(1, 0, memory) {}

  std::size_t size() const { return begin.size() - 1; }
  std::span<const Index> operator[](std::size_t loop) const {
    return {half_edges.data() + begin[loop], begin[loop + 1] - begin[loop]};
  }

  Array<Index> half_edges;
  Array<std::size_t> begin;
  std::size_t tangled_edges = 0;  // boundary edges in no loop
};

// Finds the loops. Where holes touch at a vertex, each has its own loop. O(n). Throws Error "cancelled".
BoundaryLoops boundary_loops(const Soup& soup, const base::Host& host);

}  // namespace orbicube::repair
