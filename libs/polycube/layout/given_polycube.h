// A polycube that is given: from a mesh of it, or from corners and the loops around its faces.
#pragma once

#include "polycube/outputs/patch_graph.h"
#include "polycube/voxels/voxel_solid.h"

namespace orbicube::polycube {

// A face, by the corners around it: loops one after another, each counter-clockwise seen from outside (holes then run
// the other way).
struct GivenPatch {
  AxisLabel label;
  std::span<const Index> loop_begin;  // of each loop in `corners`, and the end
  std::span<const Index> corners;
};

struct TargetPolycube {
  explicit TargetPolycube(std::pmr::memory_resource* memory) : map(memory), graph(memory) {}

  SurfaceMap map;  // of the polycube's own triangles to themselves, certified
  PatchGraph graph;
  std::int64_t genus = 0;
};

// Of triangles of a polycube. Coordinates along an axis that differ by at most `tolerance` become one. Throws Error
// "unsupported" with what is wrong with it as a polycube, "index-range", "non-finite", "cancelled".
TargetPolycube target_of_mesh(std::span<const Vector3> positions, std::span<const Triangle> triangles, double tolerance,
                              const base::Host& host);

// Of corners and faces. Throws the same; loops must consist of edges along the axes, each of which two faces share.
TargetPolycube target_of_patches(std::span<const Vector3> corners, std::span<const GivenPatch> patches,
                                 const base::Host& host);

// The cells that are inside, between the planes of its faces, with an empty layer around.
VoxelSolid solid_of(const PatchGraph& graph, const base::Host& host);

}  // namespace orbicube::polycube
