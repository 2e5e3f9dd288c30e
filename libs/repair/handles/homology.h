// Which cycles of edges separate a surface: a code of each edge, so that the sum of the codes of a cycle (exclusive or)
// is 0 where it bounds a piece of the surface.
#pragma once

#include "mesh/topology/connectivity.h"
#include "repair/types.h"

namespace orbicube::repair {

struct Homology {
  Array<std::uint64_t> codes;  // for each half-edge that of its edge
  std::int64_t genus = 0;      // sum over all parts
};

// Computes the codes. A tree of vertices and a tree of faces that crosses none of its edges leave 2 g
// edges on a closed surface of genus g (tree-cotree, Eppstein 2003); each closes a cycle of faces, whose edges get one
// bit, or a pseudo-random word where there are more than 64. O(n * g) at worst. Throws Error "cancelled".
Homology homology_codes(const Soup& soup, const mesh::Connectivity& connectivity, const base::Host& host);

}  // namespace orbicube::repair
