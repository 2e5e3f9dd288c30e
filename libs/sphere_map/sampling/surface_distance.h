// How far two surfaces are apart: the distance from points of one to the nearest point of the other, and back (Cignoni,
// Rocchini and Scopigno, Metro: measuring error on simplified surfaces, 1998).
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::sphere_map {

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

// In the unit of the positions. On the threads of the host, the same bits for any number of them. O(n log n).
// Both need a triangle, and coordinates whose squares are in the range of double. Throws Error "invalid-argument",
// "cancelled".
SurfaceDistance surface_distance(std::span<const mesh::Vector3> first_positions,
                                 std::span<const mesh::Triangle> first_triangles,
                                 std::span<const mesh::Vector3> second_positions,
                                 std::span<const mesh::Triangle> second_triangles, const base::Host& host);

}  // namespace orbicube::sphere_map
