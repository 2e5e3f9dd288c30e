// Layers of cells that a map must not let collapse: from each face of the boundary and each singular edge one goes
// along the frames, and from the ends of singular curves along these; what one comes upon that has an integer
// coordinate of that direction is at least one cell away.
#pragma once

#include "volume_map/frames/integer_rounding.h"
#include "volume_map/frames/seamless_system.h"

namespace orbicube::volume_map {

struct LayerBounds {
  explicit LayerBounds(std::pmr::memory_resource* memory) : bounds(memory), from(memory), to(memory) {}

  Array<LowerBound> bounds;  // with forms of the system
  Array<Vector3> from, to;   // where each was found
};

// Adds forms to the system. What is farther to the side than half a cell does not count. O(n) for each of the ways, the
// length of a way in tetrahedra. Throws Error "cancelled".
LayerBounds find_layer_bounds(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                              const mesh::EdgeRings& rings, const FrameCut& cut, double cell_length,
                              SeamlessSystem& system, const base::Host& host);

}  // namespace orbicube::volume_map
