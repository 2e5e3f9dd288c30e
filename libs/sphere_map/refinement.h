// From a tetrahedron on the sphere back to the whole mesh: vertex splits into spherical kernels, with every level
// optimised before the next.
#pragma once

#include "base/team.h"
#include "sphere_map/decimation.h"
#include "sphere_map/method.h"

namespace orbicube::sphere_map {

// Directions of all vertices that have a ring at the end; zero for the others. `decimation` is used up. Throws Error
// no-valid-result when a kernel is empty, which only rounding can cause. `least_area` is for triangle_shape
// (distortion.h), `partial` as for compute().
Array<Vector3> refine(Decimation& decimation, std::span<const Vector3> positions, const Schedule& schedule,
                      double least_area, const base::Host& host, const base::Team& team, Partial* partial);

}  // namespace orbicube::sphere_map
