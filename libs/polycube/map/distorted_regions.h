// Parts of a surface that a polycube has no room for: a protrusion on a flat face, say.
#pragma once

#include "polycube/surface/surface.h"

namespace orbicube::polycube {

struct DistortedRegions {
  explicit DistortedRegions(std::pmr::memory_resource* memory) : of_triangle(memory) {}

  std::size_t count = 0;
  Array<Index> of_triangle;  // which region, the largest first; no_index for none
};

// Connected sets of triangles whose angles or areas the map changes much, with what they enclose and what is next to
// them; of at least 0.2 % of the surface. `map` is one of the surface.
DistortedRegions find_distorted_regions(const Surface& surface, const SurfaceMap& map, const base::Host& host);

}  // namespace orbicube::polycube
