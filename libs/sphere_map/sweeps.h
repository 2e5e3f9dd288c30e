// Optimisation of a large level of the hierarchy: sweeps over its vertices, those of one colour side by side.
//
// Gauss-Seidel with a colouring: no two vertices of a colour are neighbours, so the order within a colour does not
// matter. Vertices whose neighbourhood lies still are skipped.
#pragma once

#include "sphere_map/level.h"
#include "sphere_map/relaxation.h"

namespace orbicube::sphere_map {

// Lowers the energy of the level, as relax() does. `scratch` has one a slot of Waves, and `place` maps each vertex of
// the level to its place in it. Answers the vertices whose stars are far worse than the mean: a few steps more and they
// would stand in the way of all others. About 14 bytes a vertex.
Array<Index> sweep(const Energy& energy, const Level& level, std::span<const Index> place,
                   const RelaxationLimits& limits, std::span<Vector3> directions, std::span<StepScratch> scratch,
                   const base::Host& host, const base::Team& team);

}  // namespace orbicube::sphere_map
