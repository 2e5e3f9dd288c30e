// Voxels of an octree (the dissertation's section 4.2.1): the bounding box of a surface is cut into eight boxes, and
// these again, down to a depth. A box that is inside or outside as a whole is not cut.
#pragma once

#include "polycube/voxels/occupancy.h"
#include "polycube/voxels/voxel_solid.h"

namespace orbicube::polycube::dissertation {

struct OctreeOptions {
  int depth = 0;        // of the smallest boxes, 0 or more
  double inside = 0.5;  // a smallest box is inside where more than this fraction of it is
};

// The maximum depth that the cells of `occupancy` allow along each axis.
int max_octree_depth(const Occupancy& occupancy);

// The solid of all inside boxes, with one empty layer around. The root is inside where it is not cut. Its topology is
// what it happens to be. Throws Error "cancelled".
VoxelSolid octree_solid(const Occupancy& occupancy, const OctreeOptions& options, const base::Host& host);

}  // namespace orbicube::polycube::dissertation
