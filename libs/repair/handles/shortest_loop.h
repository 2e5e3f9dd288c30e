// The shortest loop of edges that does not separate the surface: around a handle or through a tunnel.
#pragma once

#include <span>

#include "mesh/topology/connectivity.h"
#include "repair/types.h"

namespace orbicube::repair {

struct EdgeLoop {
  explicit EdgeLoop(std::pmr::memory_resource* memory) : vertices(memory) {}

  Array<Index> vertices;  // each one once; none where there is no loop
  double length = 0;
};

// Finds the shortest loop of those that are shorter than `limit`: by Dijkstra's method from each vertex at an edge with
// a code, since every such loop passes one, as far as half the length of the best loop (after Erickson and Har-Peled
// 2004, "Optimally cutting a surface into a disk"). `codes` as those of homology_codes. Of equal lengths the one found
// first. Throws Error "cancelled".
EdgeLoop shortest_loop(const Soup& soup, const mesh::Connectivity& connectivity, std::span<const std::uint64_t> codes,
                       double limit, const base::Host& host);

}  // namespace orbicube::repair
