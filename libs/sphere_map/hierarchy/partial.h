// What is kept of a hierarchy that could not be finished (sphere_map.h: Partial).
#pragma once

#include "sphere_map/hierarchy/vertex_rings.h"
#include "sphere_map/sphere_map.h"

namespace orbicube::sphere_map {

// Puts `directions`, zero for vertices that have not been split in yet, into `partial` unless what is there has more
// vertices placed. Those without a place get that of the vertex that they were merged into; `collapses` are all, or
// none when every vertex has a place. `partial` may be null.
void keep_partial(std::span<const Collapse> collapses, std::span<const Vector3> directions, Partial* partial);

}  // namespace orbicube::sphere_map
