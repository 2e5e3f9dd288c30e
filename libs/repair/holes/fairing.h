// A patch bent so that it continues the surface around it: the thin-plate energy, with the umbrella operator of inverse
// edge lengths (Desbrun, Meyer, Schroeder and Barr 1999; Kobbelt, Campagna, Vorsatz and Seidel 1998), at its minimum.
#pragma once

#include <span>

#include "repair/holes/refinement.h"

namespace orbicube::repair {

// Points of edges of the surface outside of the patch: from a point of the loop to a point.
struct OuterEdge {
  Index from;
  Vector3 to;
};

// Moves the points of the patch that are not on its loop. Returns whether the system could be solved; else nothing
// moves. O(n^1.5) as a rule. Throws Error "cancelled".
bool fair(Patch& patch, std::span<const OuterEdge> outside, const base::Host& host);

}  // namespace orbicube::repair
