// Faces turned so that they agree with their neighbors, and outward.
#pragma once

#include <span>

#include "repair/types.h"

namespace orbicube::repair {

// Turns faces so that each edge of two faces is passed once in each direction, the fewer of each patch of faces that
// such edges connect. Where the faces at each edge of more than two then pass it as often in one direction as in the
// other, patches stay as they are relative to each other; else each counts for itself. What has no boundary and a
// negative volume is turned outward. Returns false, and changes nothing, if the surface is not orientable. O(n). Throws
// Error "cancelled".
bool orient_patches(Soup& soup, const base::Host& host);

// Turns parts (connected by edges) without boundary outward: those of negative volume.
void turn_parts_outward(Soup& soup, const base::Host& host);

// Returns the number of triangles that are turned against their source in the input. O(n).
std::size_t count_turned(const Soup& soup, std::span<const Triangle> input);

}  // namespace orbicube::repair
