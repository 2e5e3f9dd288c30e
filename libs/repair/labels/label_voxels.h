// The voxels of one label of an image.
#pragma once

#include "repair/labels/surface_of_labels.h"
#include "repair/labels/voxels.h"

namespace orbicube::repair {

struct LabelVoxels {
  Voxels voxels;
  std::array<double, 3> origin{};  // of voxel (0, 0, 0) in the image; may be negative
  std::int32_t label = 0;
  std::size_t count = 0, border_count = 0;
};

// Checks the image and cuts out the box of the label, with two layers of background around it. Throws Error
// "invalid-argument", "cancelled".
LabelVoxels voxels_of_label(const LabelImage& image, std::int32_t label, const base::Host& host);

}  // namespace orbicube::repair
