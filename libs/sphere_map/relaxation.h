// Optimisation of a whole level of the hierarchy, vertex by vertex, those first that promise most.
//
// The dissertation's Algorithm 1 with the flaw of its stopping rule mended (it ends on one unlucky vertex): here the
// work ends when the gain of the last pass over as many vertices as the level has falls below a part of the energy. The
// priority is the gain that a vertex's or its neighbour's latest step brought, in place of eq. 3.6: it needs no
// gradient of vertices that are not looked at.
#pragma once

#include "base/host.h"
#include "sphere_map/bucket_queue.h"
#include "sphere_map/vertex_rings.h"
#include "sphere_map/vertex_step.h"

namespace orbicube::sphere_map {

// Vertices with more triangles than this take one step a pass, outside the queue: one is woken by each neighbour that
// moves, and a step costs as much as the star has triangles.
inline constexpr std::size_t large_star = 100;

// The vertices of one level with their stars side by side: star i is stars[star_begin[i] .. star_begin[i + 1]).
struct Level {
  explicit Level(std::pmr::memory_resource* memory)
      : vertices(memory), large(memory), star_begin(memory), stars(memory) {}

  // Rebuilds the stars of `vertices`, and the areas of `energy`, from the surface positions.
  void build(const VertexRings& rings, std::span<const Vector3> positions, Energy& energy, const base::Host& host);

  std::span<const StarTriangle> star(std::size_t i) const {
    return {stars.data() + star_begin[i], star_begin[i + 1] - star_begin[i]};
  }

  Array<Index> vertices;  // set by the caller; in ascending order memory is passed through in order
  Array<Index> large;     // those of more than large_star triangles
  Array<std::size_t> star_begin;
  Array<StarTriangle> stars;
};

// Sum over the level's triangles.
double level_energy(const Energy& energy, const Level& level, std::span<const Vector3> directions);

struct RelaxationLimits {
  std::size_t passes;    // at most this many steps a vertex in the mean
  double relative_gain;  // ends when a pass gains less than this part of the energy
  double movement;       // a vertex that moved less than this part of its nearest edge does not wake its neighbours
};

// Lowers the energy of the level. Scratch of the size of the whole mesh: `queue` takes vertex indices, `place` maps
// each vertex of the level to its place in it. Answers the energy.
double relax(const Energy& energy, const Level& level, const RelaxationLimits& limits, std::span<Vector3> directions,
             BucketQueue& queue, std::span<Index> place, StepScratch& scratch, const base::Host& host);

}  // namespace orbicube::sphere_map
