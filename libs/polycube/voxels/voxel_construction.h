// A polycube and a map to it from voxels, for closed surfaces of any genus.
//
// A certified voxelisation (voxelisation.h) is simplified to the budget of corners (simplification.h), its surface
// becomes a layout of rectangles (layout.h), which is drawn on the surface in space (tracing.h) and mapped
// (layout_map.h). Each of these keeps the topology by construction; what can fail is the room that floating-point
// numbers leave, and then fewer corners and other grids are tried.
#pragma once

#include <array>

#include "polycube/labels/label_construction.h"

namespace orbicube::polycube {

struct VoxelConstructionOptions {
  std::size_t corners = 0;         // maximum of the polycube, or the fewest that it can be brought to; 0: any number
  std::size_t max_polycubes = 24;  // that are drawn on the surface and mapped
  std::size_t first_grid = 0;      // of voxel_grids, where those before have been tried
};

// Grids begin with this number of cells along the longest axis: finer and coarser ones make other polycubes.
inline constexpr std::array voxel_grids = {40, 60, 20, 84};

// Of a closed, connected, oriented surface that is outward-oriented. `tried` counts polycubes.
// Throws Error "no-valid-result" with what stood in the way of each, "not-closed", "cancelled".
Construction construct_by_voxels(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                 const VoxelConstructionOptions& options, const base::Host& host);

}  // namespace orbicube::polycube
