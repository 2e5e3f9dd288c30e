// A surface cut into four-sided patches, each meshed as a grid. The rows of patches that lie side by side (chords of
// the quad mesh) are cut into the same number of strips, each row into its own number, so that any total can be met
// closely and triangles are near to equal sides, while the topology is that of the patches.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

using Quad = std::array<Index, 4>;

// A closed manifold of quads, counter-clockwise seen from outside. Side k of a quad goes from corner k to corner k + 1;
// half-edge 4 q + k is side k of quad q. No two quads may share two sides with the same ends.
struct QuadComplex {
  std::vector<Vector3> corners;
  std::vector<Quad> quads;
};

inline Index next_in_quad(Index half_edge) {
  return half_edge % 4 == 3 ? half_edge - 3 : half_edge + 1;
}
inline Index previous_in_quad(Index half_edge) {
  return half_edge % 4 == 0 ? half_edge + 3 : half_edge - 1;
}

// The half-edge on the other side of each half-edge's edge. Throws Error "internal" when an edge has not two quads that
// pass it in opposite directions.
std::vector<Index> twins_of(const QuadComplex& complex);

// Where the points of each patch are.
class PatchSurface {
 public:
  virtual ~PatchSurface() = default;
  // The patch that `at` is queried from now on.
  virtual void select(std::size_t quad) = 0;
  // Corners 0, 1, 2, 3 are at (u, v) = (0, 0), (1, 0), (1, 1), (0, 1). Neighbors must agree on the side they share.
  virtual Vector3 at(double u, double v) const = 0;
};

// Meshes the surface with about `triangles` triangles, at least two a patch. `side_lengths` has one entry a half-edge.
// Each grid cell is cut along its shorter diagonal. O(triangles).
Mesh mesh_patches(const QuadComplex& complex, PatchSurface& surface, std::span<const double> side_lengths,
                  std::size_t triangles, const base::Host& host);

}  // namespace orbicube::mesh
