// Optimization of a large level of the hierarchy: sweeps over its vertices, those of one color side by side.
//
// Gauss-Seidel with a coloring: no two vertices of a color are neighbors, so the order within a color does not
// matter. Vertices whose neighborhood lies still are skipped.
#pragma once

#include "sphere_map/hierarchy/level.h"
#include "sphere_map/optimization/relaxation.h"

namespace orbicube::sphere_map {

// Lowers the energy of the level, as relax() does. `scratch` has one a slot of the dependency levels, and `place` maps
// each vertex of the level to its place in it. Returns the vertices whose stars are far worse than the mean: a few
// steps more and they would stand in the way of all others. About 14 bytes a vertex.
Array<Index> sweep(const Energy& energy, const Level& level, std::span<const Index> place,
                   const RelaxationLimits& limits, std::span<Vector3> directions, std::span<StepScratch> scratch,
                   const base::Host& host, const base::ThreadPool& pool);

}  // namespace orbicube::sphere_map
