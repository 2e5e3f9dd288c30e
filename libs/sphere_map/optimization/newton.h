// Newton's method on all vertices of a level at once.
//
// Vertex by vertex, long dependency_levels of a map take as many passes as the level is wide; here they go in a few
// steps. The Hessian is the true one in tangent coordinates (triangle_model.h): projecting each triangle's own part to
// be positive would stall. Steps minimize the model within a trust region, by conjugate gradients (star_matrix.h) with
// a coarse space (coarse_space.h). A step is only taken when it lowers the energy and leaves every triangle safely
// positive. A few vertices of strong nonlinearity would keep all steps short: where the gain is less than the model
// says, single vertices are moved in between.
#pragma once

#include <functional>

#include "base/threads/thread_pool.h"
#include "sphere_map/hierarchy/level.h"

namespace orbicube::sphere_map {

struct NewtonLimits {
  int steps;             // maximum number
  int solver_steps;      // of conjugate gradients for each
  double relative_gain;  // ends when a step gains less than this part of the energy
};

// Lowers the energy of the level. `smooth` lowers it by steps of single vertices of `directions`. `place` maps each
// vertex of the level to its place in it. About 420 bytes a vertex while it runs. Returns the energy.
double newton(const Energy& energy, const Level& level, const NewtonLimits& limits, std::span<const Index> place,
              std::span<Vector3> directions, const std::function<void()>& smooth, const base::Host& host,
              const base::ThreadPool& pool);

}  // namespace orbicube::sphere_map
