// How far two surfaces are from each other.
#pragma once

#include <span>

#include "hexmesh/types.h"

namespace orbicube::hexmesh {

// The farthest that a vertex or a point in between, of which there is one on each `spacing` of an edge, of one surface
// is from the other, both ways. A lower bound of the Hausdorff distance. Throws Error "cancelled".
double surface_distance(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                        std::span<const Vector3> other_positions, std::span<const mesh::Triangle> other_triangles,
                        double spacing, const base::Host& host);

}  // namespace orbicube::hexmesh
