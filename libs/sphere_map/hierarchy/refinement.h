// From a tetrahedron on the sphere back to the whole mesh: vertex splits into spherical kernels, with every level
// optimized before the next.
#pragma once

#include "base/threads/thread_pool.h"
#include "sphere_map/hierarchy/decimation.h"
#include "sphere_map/optimization/method.h"

namespace orbicube::sphere_map {

// Directions of all vertices that have a ring at the end; zero for the others. `decimation` is used up. Throws Error
// no-valid-result when a kernel is empty, which only rounding can cause. `partial` as for compute().
Array<Vector3> refine(Decimation& decimation, std::span<const Vector3> positions, const Schedule& schedule,
                      const RestTriangles& rest, const base::Host& host, const base::ThreadPool& pool,
                      Partial* partial);

}  // namespace orbicube::sphere_map
