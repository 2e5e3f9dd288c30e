// Triangles across a loop of vertices, without others: those with the smallest largest dihedral angle, and among these
// of the smallest area (Liepa 2003, "Filling holes in meshes"; Barequet and Sharir 1995), by dynamic programming.
#pragma once

#include <functional>
#include <span>

#include "repair/types.h"

namespace orbicube::repair {

// A closed polygon in space.
struct Loop {
  std::span<const Vector3> points;
  // For edge i, from point i to point i + 1: the corner of the triangle across it that is not on it; what has no such
  // triangle has a point with a NaN.
  std::span<const Vector3> apexes;
  // Pairs i, j of points, i < j, that an edge connects already; sorted.
  std::span<const std::array<Index, 2>> connected;
  // Whether a triangle of numbers of points is to be avoided: the fewest such ones come before angle and area. Empty:
  // none is.
  std::function<bool(const Triangle&)> avoids{};
};

// Returns n - 2 triangles of the numbers of points, each passing edges of the polygon from point i to point i + 1, or
// none if any triangulation needs an edge that is there already. O(n^3) up to 150 points; loops of more are divided by
// the triangulation of every k-th point, which takes O(n * 150^2) and is no longer the optimum. Throws Error
// "cancelled".
Array<Triangle> triangulate(const Loop& loop, const base::Host& host);

}  // namespace orbicube::repair
