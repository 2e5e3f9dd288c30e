// Triangle surfaces as what harmonics are fitted to and compared with.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "harmonics/functions/basis.h"

namespace orbicube::harmonics {

using Triangle = std::array<std::uint32_t, 3>;

// A third of the area of its triangles for each vertex: the weights that a fit of a surface has by default, so that
// each piece of the surface counts by its own size, not by how many vertices it has or how large it is on the sphere.
// Throws Error: index-range.
Array<double> vertex_areas(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const base::Host& host);

// The reconstruction error of the dissertation's section 3.3.2: e(A, B) = max(d(A, B), d(B, A)), where d(A, B) is the
// mean over the points of A of the distance to the nearest point of B. In the unit of the points; the dissertation's
// and the reference figures are for surfaces scaled to the area 4 pi. O(n log n).
// Throws Error: invalid-argument for an empty set or what is not finite.
double mean_distance(std::span<const Vector3> a, std::span<const Vector3> b, const base::Host& host);

}  // namespace orbicube::harmonics
