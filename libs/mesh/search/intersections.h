// Where a surface meets itself, decided by exact predicates.
#pragma once

#include <array>
#include <limits>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// Whether triangles p and q, numbers of three positions each, have a point in common besides the vertices and the edge
// that they share by number. Two triangles on the same three vertices do. Exact; both triangles must have area.
bool triangles_intersect(std::span<const Vector3> positions, const Triangle& p, const Triangle& q);

// Pairs of triangles that intersect, the lower number first, in ascending order, the first `most` of them. Triangles
// without area are left out. O(n log n + pairs of overlapping boxes); the same for any number of threads.
// Throws Error "cancelled".
Array<std::array<Index, 2>> intersecting_triangles(std::span<const Vector3> positions,
                                                   std::span<const Triangle> triangles, const base::Host& host,
                                                   std::size_t most = std::numeric_limits<std::size_t>::max());

// A quad of a surface stands for the four triangles of both its diagonals: two quads intersect when a triangle of one
// intersects a triangle of the other beyond the vertices that they share, or when the quads share three vertices. Where
// no two quads do, no choice of diagonals makes a closed surface meet itself, nor do bilinear patches between quads
// that share no vertex: these lie in the tetrahedra of their corners, and what enters one goes through a half. Halves
// without area are left out. Exact.
bool quads_intersect(std::span<const Vector3> positions, const std::array<Index, 4>& p, const std::array<Index, 4>& q);

// Pairs of quads that intersect, and pairs (i, i) of quads whose own halves lie over each other in one plane, in
// ascending order, the first `most` of them. Cost and threads as above. Throws Error "cancelled".
Array<std::array<Index, 2>> intersecting_quads(std::span<const Vector3> positions,
                                               std::span<const std::array<Index, 4>> quads, const base::Host& host,
                                               std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace orbicube::mesh
