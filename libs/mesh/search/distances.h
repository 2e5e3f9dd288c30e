// How far two surfaces or two sets of points are apart, from points of one to the nearest point of the other and back.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// From the points of one surface to the other: its vertices and the centroids of its triangles, which weigh 1/12 each
// and 3/4 of a triangle's area (exact for what is quadratic on triangles).
struct Distances {
  double mean = 0;
  double root_mean_square = 0;
  double largest = 0;  // of the points that were looked at
};

struct SurfaceDistance {
  Distances from_first, from_second;
};

// Measures the distances of two surfaces (Cignoni, Rocchini and Scopigno, Metro: measuring error on simplified
// surfaces, 1998). In the unit of the positions. On the threads of the host, the same bits for any number of them. O(n
// log n). Both need a triangle, and coordinates whose squares are in the range of double. Throws Error
// "invalid-argument", "cancelled".
SurfaceDistance surface_distance(std::span<const Vector3> first_positions, std::span<const Triangle> first_triangles,
                                 std::span<const Vector3> second_positions, std::span<const Triangle> second_triangles,
                                 const base::Host& host);

// Returns max(d(A, B), d(B, A)), where d(A, B) is the mean over the points of A of the distance to the nearest point of
// B: the reconstruction error of the dissertation's section 3.3.2, whose figures are for surfaces scaled to the area
// 4 pi. In the unit of the points, whose squares must be in the range of double. On the threads of the host, the same
// bits for any number of them. O(n log n). Throws Error "invalid-argument" for an empty set or what is not finite,
// "cancelled".
double mean_distance(std::span<const Vector3> a, std::span<const Vector3> b, const base::Host& host);

}  // namespace orbicube::mesh
