// Narrow gaps of a closed surface made wider, for what has to tell both of their walls from each other: grids of cells
// do not see a gap that is narrower than a cell, and take both walls for one solid.
#pragma once

#include "mesh/mesh.h"
#include "volume_map/types.h"

namespace orbicube::volume_map {

// Positions of the vertices, those at gaps narrower than `width` moved into the solid, so that gaps are about so wide,
// but by no more than a third of what the solid is thick there. A gap is what is before a triangle, along its normal,
// up to a triangle that looks against it. Empty where there is none. The surface may meet itself then, at concave edges
// and where triangles are shorter than `width`. O(n log n) where gaps are few; the same for any number of threads.
// Throws Error "cancelled".
Array<Vector3> widened_gaps(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles, double width,
                            const base::Host& host);

}  // namespace orbicube::volume_map
