// A polycube and a map to it from axis labels of the surface's triangles.
//
// The surface is turned towards the axes, labeled by graph cuts from coarse to fine with normals as they are, after
// some smoothing, and turned where protrusions bend (label_cut.h, normal_flow.h, normal_turning.h), the labels are
// repaired (label_repair.h), and each labeling that may be a polycube is made into a map (labelled_map.h, or
// labelled_target.h). Of the certified ones that of minimum distortion within the budget of corners is the result, once
// parts that it has no room for, such as protrusions, have got boxes of their own (distorted_regions.h).
//
// Surfaces of many triangles are decimated for all of that. The labels then go back to the whole surface with the
// vertices (decimation.h), which keeps patches, arcs and corners; the whole surface is decimated again with them,
// mapped where it is coarse, and the map is brought to all its vertices (map_refinement.h).
#pragma once

#include "polycube/map/certificate.h"
#include "polycube/surface/distortion.h"

namespace orbicube::polycube {

struct LabelConstructionOptions {
  std::size_t corners = 0;  // maximum of the polycube; 0: any number
  // More than the given number only where the map is better by 3 %; 0: all alike.
  std::size_t preferred_corners = 0;
  std::uint64_t seed = 0;
};

struct Construction {
  explicit Construction(std::pmr::memory_resource* memory) : map(memory), certificate(memory) {}

  SurfaceMap map;
  Certificate certificate;
  Distortion distortion;
  std::size_t tried = 0, valid = 0;  // labelings
  std::size_t grid = 0;              // of voxels: the number in voxel_grids
};

// Of a closed, connected, oriented surface. Throws Error "no-valid-result" with what stood in the way, "cancelled", and
// what mesh::Connectivity does.
Construction construct_by_labels(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                 const LabelConstructionOptions& options, const base::Host& host);

}  // namespace orbicube::polycube
