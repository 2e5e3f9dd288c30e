// A surface around all triangles, at a distance from them: what is closed, oriented, manifold and free of
// self-intersections whatever the triangles are.
#pragma once

#include "repair/types.h"

namespace orbicube::repair {

struct WrapFigures {
  std::size_t triangles = 0;
  double cell = 0;  // size of the grid's cells
};

// Replaces the triangles by the boundary of what cannot be reached from outside without coming as near as `offset` to a
// triangle: the distance to the triangles on a grid with cells of that size, flooded from outside, and the level set by
// marching tetrahedra (Doi and Koide 1991), which has no ambiguous cell. Gaps of the triangles narrower than twice the
// offset are closed, and what is enclosed is filled. The result is at most about twice the offset away. Throws Error
// "invalid-argument" if the grid would have more than max_wrap_nodes nodes, with the smallest possible offset;
// "cancelled". O(nodes + triangles * (size / offset)^2).
WrapFigures wrap(Soup& soup, double offset, const Context& context);

inline constexpr double max_wrap_nodes = 1 << 26U;

}  // namespace orbicube::repair
