// Distances of voxels to the nearest one of the other kind.
#pragma once

#include <array>

#include "base/host.h"
#include "repair/labels/voxels.h"

namespace orbicube::repair {

// Returns for each voxel the squared distance of its center to the nearest center of a voxel with in == kind; 0 for
// these. `spacing`: distance of neighbors along each axis. Exact but for rounding (Felzenszwalb and Huttenlocher 2012).
// O(voxels). Throws Error "cancelled".
base::Array<float> squared_distances(const Voxels& voxels, std::uint8_t kind, const std::array<double, 3>& spacing,
                                     const base::Host& host);

}  // namespace orbicube::repair
