// Whether the hexahedra of a mesh lie over each other. Hexahedra whose trilinear maps are positive cover space evenly
// on either side of their boundary; where that does not meet itself and its components lie inside each other as outer
// walls, cavities and pieces do, no point is covered twice.
#pragma once

#include "hexmesh/certificate/hex_mesh.h"

namespace orbicube::hexmesh {

// Sets `intersections`, `misplaced_parts` and `first_intersection` of the quality by the boundary of a conforming mesh,
// exactly but for the sides of components, which are decided by winding numbers at a vertex of each where no quads
// intersect. O(n log n) and O(n) for each component within the box of another. Throws Error "cancelled".
void measure_embedding(std::span<const Vector3> positions, std::span<const Quad> quads, HexQuality& quality,
                       const base::Host& host);

}  // namespace orbicube::hexmesh
