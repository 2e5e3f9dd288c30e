// How thick a solid of voxels is around each cell: the largest ball inside it that covers the cell (Hildebrand and
// Ruegsegger 1997). Cells outside have the thickness of the nearest inside cell.
#pragma once

#include "polycube/voxels/voxel_solid.h"

namespace orbicube::polycube {

// Radii in cells, at least about 1. O(n) for the distances; balls are left out that would change a thickness by less
// than a tenth, which keeps the rest near O(n) as well.
Array<float> local_thickness(const VoxelSolid& solid, const base::Host& host);

}  // namespace orbicube::polycube
