// The topology of an object of voxels: parts, cavities, handles.
#pragma once

#include <array>
#include <cstdint>

#include "base/host.h"
#include "repair/labels/voxels.h"

namespace orbicube::repair {

struct VoxelPartFigures {
  std::size_t found = 0;           // parts, connected through faces
  std::size_t kept = 0;            // the largest ones
  std::size_t dropped_voxels = 0;  // of the others
  std::size_t cavities = 0;        // parts of the background that do not reach the outside
  std::size_t filled_voxels = 0;   // of the cavities that were filled
};

// Removes all but the `keep` largest parts (0: no limit), the earlier one of two of equal size. O(voxels). Throws Error
// "cancelled".
void keep_voxel_parts(Voxels& voxels, std::size_t keep, VoxelPartFigures& figures, const base::Host& host);

// Adds parts of the background, connected through faces, edges or corners, that the outermost layer is no part of.
// O(voxels). Throws Error "cancelled".
void fill_cavities(Voxels& voxels, VoxelPartFigures& figures, const base::Host& host);

struct HandleVoxelFigures {
  std::size_t added_voxels = 0;    // that close tunnels
  std::size_t removed_voxels = 0;  // that cut handles
  bool changed() const { return added_voxels + removed_voxels > 0; }
};

// Makes a connected object without cavities a ball, topologically: cuts handles and closes tunnels at their thinnest
// places. From the deepest voxel the object grows by simple voxels, the deeper ones first: what cannot be added cuts
// the handles. Likewise a box around it shrinks to the object plus what closes the tunnels. Of the ways to close the
// tunnels up to some size and cut the other handles, the one that changes the fewest voxels is taken. The object needs
// two layers of background around it. O(n log n) of the voxels times some ten. Throws Error "cancelled".
HandleVoxelFigures remove_handles(Voxels& voxels, const std::array<double, 3>& spacing, const base::Host& host);

// Makes each part of an object without cavities a ball by cutting its handles, as above. Does not join parts. O(n log
// n). Throws Error "cancelled".
HandleVoxelFigures cut_handles(Voxels& voxels, const std::array<double, 3>& spacing, const base::Host& host);

// The Euler characteristic of the object, connected through faces: parts + cavities - handles.
std::int64_t euler_characteristic(const Voxels& voxels);

}  // namespace orbicube::repair
