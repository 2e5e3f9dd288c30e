// Where the smooth boundary of an object crosses the edges between voxel centers.
#pragma once

#include "base/host.h"
#include "repair/labels/voxels.h"

namespace orbicube::repair {

// The object's indicator function, smoothed by a Gaussian. Values in [0, 1].
class SmoothedVoxels {
 public:
  // `deviation`: standard deviation in voxels along each axis; 0: not smoothed. O(voxels * deviation). Throws Error
  // "cancelled".
  SmoothedVoxels(const Voxels& voxels, double deviation, const base::Host& host);

  // Returns where the boundary crosses the edge from v to its neighbor along the axis, of which one is in the object,
  // as a fraction of the edge in [0.5 - max_slide, 0.5 + max_slide]. The level is the mean value midway between voxels
  // of both kinds around the edge: vertices slide outward as much as inward there, so that neither curved nor thin
  // shapes lose volume.
  double crossing(VoxelIndex v, int axis, double max_slide) const;

 private:
  double level(VoxelIndex v, int axis) const;

  const Voxels& voxels_;
  base::Array<float> value_;
};

}  // namespace orbicube::repair
