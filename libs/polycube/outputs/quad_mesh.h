// Quadrilateral meshes from a regular grid on a polycube.
//
// The planes of the polycube's patches along an axis are shared by everything that they cross, so integer numbers of
// cells for the intervals between them make the grids of all patches fit: every vertex inside a patch has four quads.
// Corners of cells go to the surface through the map, each in the very triangle that has it by exact arithmetic.
#pragma once

#include "base/host.h"
#include "polycube/outputs/patch_graph.h"

namespace orbicube::polycube {

using Quad = std::array<Index, 4>;

struct GridOptions {
  double edge_length = 0;  // of cells on the polycube; 0: what gives about the given number of quads
  std::size_t quads = 10000;
};

// The lines of the grid along each axis.
struct PolycubeGrid {
  explicit PolycubeGrid(std::pmr::memory_resource* memory)
      : layers{Array<double>(memory), Array<double>(memory), Array<double>(memory)},
        cells{Array<Index>(memory), Array<Index>(memory), Array<Index>(memory)} {}

  std::array<Array<double>, 3> layers;  // the planes that patches lie in, ascending
  std::array<Array<Index>, 3> cells;    // in each interval between two of them, at least one
};

// Numbers of cells near to the length of their interval over edge_length. Where a number of quads is requested, it is
// met as closely as one edge length for all intervals can; each rectangle between layers has at least one quad.
// Throws Error "invalid-argument" for options that are not positive or give more than 10^7 quads, "cancelled".
PolycubeGrid make_grid(const PatchGraph& graph, const GridOptions& options, const base::Host& host);

struct QuadMesh {
  explicit QuadMesh(std::pmr::memory_resource* memory)
      : positions(memory), polycube(memory), quads(memory), patches(memory), triangles(memory), weights(memory) {}

  // Of each vertex.
  Array<Vector3> positions;  // on the surface
  Array<Vector3> polycube;
  // Of each quad: corners counter-clockwise seen from outside, and the patch.
  Array<Quad> quads;
  Array<Index> patches;
  // Of each vertex: the triangle of the map that has it, and its weights at the corners, none negative, sum 1.
  Array<Index> triangles;
  Array<Vector3> weights;
};

// The quads of a grid on the polycube, without a surface: `positions`, `triangles` and `weights` stay empty. Their
// order, and that of vertices, depends on the polycube and the grid alone.
QuadMesh mesh_grid(const PatchGraph& graph, const PolycubeGrid& grid, const base::Host& host);

// Takes the vertices to the surface of a certified map to that polycube, which may be another than the one that the
// graph was made of. O(n log n). Throws Error "invalid-argument" when a vertex is in no triangle, "cancelled".
void sample_grid(const SurfaceMap& map, QuadMesh& mesh, const base::Host& host);

// The quality measures of users of quad meshes.
struct QuadQuality {
  std::size_t irregular = 0;        // vertices with other than four quads
  double min_scaled_jacobian = 0;   // of the four corners of a quad, by the normal of its diagonals; 1 for a square
  double mean_scaled_jacobian = 0;  // of the minimum of each quad
  std::size_t not_convex = 0;       // quads with a scaled Jacobian of 0 or less
  double area_ratio = 0;            // largest quad over mean quad
};
QuadQuality measure_quads(std::span<const Vector3> positions, std::span<const Quad> quads, const base::Host& host);

}  // namespace orbicube::polycube
