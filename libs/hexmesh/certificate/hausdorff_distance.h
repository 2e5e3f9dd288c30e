// The Hausdorff distance of two surfaces.
#pragma once

#include <span>

#include "hexmesh/types.h"

namespace orbicube::hexmesh {

// Returns the largest distance of a point of either surface to the other surface: a distance that a point has, and
// short of the largest by at most the fraction `tolerance` of it. Points inside of triangles count as much as vertices:
// triangles are halved where their bounds leave a doubt, after Tang, Lee and Kim (2009). Where bounds do not close in,
// as midway between two sheets, halving ends after 200,000 and 20 times the number of triangles, and the tolerance is
// not guaranteed. Vertices in no triangle do not count. Squares of the coordinates must be in the range of double. The
// same for any number of threads. Throws Error "cancelled".
double hausdorff_distance(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                          std::span<const Vector3> other_positions, std::span<const mesh::Triangle> other_triangles,
                          double tolerance, const base::Host& host);

}  // namespace orbicube::hexmesh
