// Holes filled with patches that continue the surface around them.
#pragma once

#include "repair/types.h"

namespace orbicube::repair {

struct HoleOptions {
  std::size_t max_edges = 0;  // of the boundary loop of a hole to fill; 0: no limit
  bool fair = true;           // patches are refined and bent; else they have no vertices inside
};

struct HoleFigures {
  std::size_t found = 0;
  std::size_t filled = 0;
  std::size_t triangles = 0;  // added
  std::size_t vertices = 0;   // added
};

// Fills boundary loops. Those of vertices where several boundary edges end are left. Patches that meet the surface or
// themselves are laid again: without bending, then without refinement, at last of the triangles that meet the fewest
// others. Throws Error "cancelled".
HoleFigures fill_holes(Soup& soup, const HoleOptions& options, const Context& context);

}  // namespace orbicube::repair
