// Regular triangulations of the sphere to sample a surface on: an icosahedron's triangles cut in four, the six grids of
// a cube, rows of latitude, and the square that unfolds an octahedron. Seen from outside, triangles are
// counter-clockwise, and positive by exact arithmetic.
#pragma once

#include <cstdint>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::sphere_map {

using base::Array;
using mesh::Index;
using mesh::Triangle;
using mesh::Vector3;

enum class GridKind : std::int32_t {
  icosphere = 0,   // resolution: how often its triangles are cut in four; 10 * 4^resolution + 2 vertices
  cube = 1,        // quads along an edge of the cube, angles of equal size; 6 * resolution^2 + 2 vertices
  latitude = 2,    // bands from pole to pole, twice as many round; 2 * resolution * (resolution - 1) + 2 vertices
  octahedron = 3,  // quads along a side of the unfolded square, an even number; resolution^2 + 2 vertices
};

struct Grid {
  explicit Grid(std::pmr::memory_resource* memory) : directions(memory), triangles(memory) {}

  Array<Vector3> directions;  // of length 1
  Array<Triangle> triangles;
};

// The minimum and the largest resolution of a kind.
struct ResolutionRange {
  std::size_t least, greatest;
};
ResolutionRange resolutions(GridKind kind);

// Throws Error "invalid-argument" for an unknown kind or a resolution out of range (or an odd one for the octahedron),
// "cancelled". O(size).
Grid make_grid(GridKind kind, std::size_t resolution, const base::Host& host);

// The vertex of the cube's grid at the lattice point (i, j, k) on the surface of [0, resolution]^3.
Index cube_vertex(std::size_t resolution, std::size_t i, std::size_t j, std::size_t k);

// The vertex of the octahedron's grid at a pixel of the square of (resolution + 1)^2: column from left (x = -1) to
// right, row from top (y = 1) to bottom. Pixels on the square's border that the unfolding has torn apart are one
// vertex, as are its four corners.
Index octahedron_vertex(std::size_t resolution, std::size_t column, std::size_t row);

}  // namespace orbicube::sphere_map
