// A map of a disk of triangles onto a star-shaped polygon, positive by construction. Edges inside that join boundary
// vertices are split, then all that begin at one: the new vertices are a closed curve next to the boundary. It becomes
// a circle around a point that sees the whole boundary, so that triangles between both are positive, and vertices
// within it the means of their neighbors, which makes all triangles there positive (Tutte 1963; Floater 2003,
// "One-to-one piecewise linear mappings over triangulations").
#pragma once

#include "untangle/refine/split_mesh.h"
#include "untangle/triangles/untangle_triangles.h"

namespace orbicube::untangle {

struct StarDisk {
  explicit StarDisk(std::pmr::memory_resource* memory) : mesh({}, 0, memory), positions(memory) {}

  SplitMesh<3> mesh;
  Array<Vector2d> positions;
};

// Returns whether all triangles are positive, by exact arithmetic: not where the mesh is no disk, its boundary is not
// fixed, something else is fixed or tied, the polygon is not star-shaped, or rounding collapses a triangle. O(n log n)
// and a sparse factor; O(n^2) for a boundary of n edges that all bound the kernel. Throws Error "cancelled".
bool map_star_disk(const TriangleProblem& problem, StarDisk& disk, const base::Host& host);

// Finds a point that lies to the left of all edges of a closed polygon, far from all of them; returns whether there is
// one that the polygon goes around once.
bool kernel_point(std::span<const Vector2d> polygon, Vector2d& point, const base::Host& host);

}  // namespace orbicube::untangle
