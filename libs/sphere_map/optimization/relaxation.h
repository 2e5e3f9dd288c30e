// Optimization of a small level of the hierarchy, vertex by vertex, those first that promise most.
//
// The dissertation's Algorithm 1 with the flaw of its stopping rule mended (it ends on one unlucky vertex): here the
// work ends when the gain of the last pass over as many vertices as the level has falls below a part of the energy. The
// priority is the gain that a vertex's or its neighbor's latest step brought, in place of eq. 3.6: it needs no
// gradient of vertices that are not looked at. Larger levels are swept (sweeps.h).
#pragma once

#include "sphere_map/hierarchy/bucket_queue.h"
#include "sphere_map/hierarchy/level.h"

namespace orbicube::sphere_map {

struct RelaxationLimits {
  std::size_t passes;    // at most this many steps in the mean for each vertex that it starts with
  double relative_gain;  // ends when a pass gains less than this part of the energy
  double movement;       // a vertex that moved less than this part of its nearest edge does not wake its neighbors
};

// Lowers the energy of the level, starting with the vertices `first`. `queue` takes vertex indices; `place` maps each
// vertex of the level to its place in it.
void relax(const Energy& energy, const Level& level, std::span<const Index> place, std::span<const Index> first,
           const RelaxationLimits& limits, std::span<Vector3> directions, BucketQueue& queue, StepScratch& scratch,
           const base::Host& host, const base::ThreadPool& pool);

}  // namespace orbicube::sphere_map
