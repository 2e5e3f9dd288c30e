// The vertices of one level of the hierarchy with their stars.
#pragma once

#include "base/threads/thread_pool.h"
#include "sphere_map/hierarchy/vertex_rings.h"
#include "sphere_map/optimization/vertex_step.h"

namespace orbicube::sphere_map {

// Vertices with more triangles than this are treated apart: a step costs as much as the star has triangles, and one is
// due whenever a neighbor has moved.
inline constexpr std::size_t large_star = 100;

// Vertices are cut into pieces of this size for threads. Sums are taken piece by piece, so that they are the same for
// any number of threads.
inline constexpr std::size_t vertices_a_piece = 1024;

// Star i is stars[star_begin[i] .. star_begin[i + 1]), in the order of the ring of vertices[i].
struct Level {
  explicit Level(std::pmr::memory_resource* memory)
      : vertices(memory), large(memory), star_begin(memory), stars(memory) {}

  // Rebuilds the stars of `vertices`, and the areas of `energy`, from the surface positions.
  void build(const VertexRings& rings, std::span<const Vector3> positions, Energy& energy, const base::Host& host,
             const base::ThreadPool& pool);

  std::span<const StarTriangle> star(std::size_t i) const {
    return {stars.data() + star_begin[i], star_begin[i + 1] - star_begin[i]};
  }

  Array<Index> vertices;  // set by the caller; in ascending order memory is passed through in order
  Array<Index> large;     // those of more than large_star triangles
  Array<std::size_t> star_begin;
  Array<StarTriangle> stars;
};

// Sum over the level's triangles.
double level_energy(const Energy& energy, const Level& level, std::span<const Vector3> directions,
                    const base::Host& host, const base::ThreadPool& pool);

}  // namespace orbicube::sphere_map
