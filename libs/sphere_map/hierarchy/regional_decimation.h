// The first and longest part of a decimation, region by region and side by side.
//
// Vertices are cut into regions along a Hilbert curve. In a region those vertices may go whose neighbors all belong to
// it: what a collapse reads and writes are the rings of these. So regions know nothing of each other (only that a
// vertex of the other has a changed neighbor is marked, for the next round), and collapses of different regions can be
// listed in any order that keeps the order within each: by cost, as one queue would have done.
#pragma once

#include <cstddef>
#include <span>

#include "base/threads/thread_pool.h"
#include "sphere_map/hierarchy/collapse_costs.h"
#include "sphere_map/hierarchy/decimation.h"

namespace orbicube::sphere_map {

// With fewer regions than that it is not worth while.
constexpr std::size_t min_regions = 4;

// Takes each region down to a quarter of its vertices, or as far as it goes. `result` must be empty; it gets the
// collapses and the pool of their rings, after which one queue can go on. The result depends on region_size alone.
void decimate_regions(std::span<const Vector3> positions, std::size_t region_size, CollapseCosts& costs,
                      Decimation& result, const base::Host& host, const base::ThreadPool& pool);

}  // namespace orbicube::sphere_map
