// The Catmull-Clark surface of a control mesh of quads, as patches (Catmull and Clark, Recursively generated B-spline
// surfaces on arbitrary topological meshes, 1978). Refined by the half-edge rule of Dupuy and Vanhoey (A halfedge
// refinement rule for parallel Catmull-Clark subdivision, 2021), which needs no search for neighbors.
#pragma once

#include <vector>

#include "mesh/shapes/quad_patches.h"

namespace orbicube::mesh {

class SubdivisionSurface : public PatchSurface {
 public:
  // Every quad of the control mesh becomes a patch of 2^levels x 2^levels; 2 levels or more. O(quads 4^levels).
  SubdivisionSurface(const QuadComplex& control, int levels, const base::Host& host);

  // Length of each side of each patch, one a half-edge of the control mesh.
  std::vector<double> side_lengths(const base::Host& host);

  void select(std::size_t quad) override;
  // Cubic interpolation between the refined points.
  Vector3 at(double u, double v) const override;

 private:
  void refine(const base::Host& host);
  void fill(Index face, int level, std::size_t corner, std::ptrdiff_t along_first_side, std::ptrdiff_t along_last_side);

  int levels_;
  std::size_t cells_;  // along a side of a patch
  // The refined mesh: half-edge 4 f + k is side k of face f.
  Array<Vector3> points_;
  Array<Index> vertex_;  // where the half-edge starts
  Array<Index> twin_;
  Array<Index> edge_;
  std::size_t edge_count_ = 0;
  Array<Vector3> grid_;  // of the selected patch, (cells_ + 1)^2
};

}  // namespace orbicube::mesh
