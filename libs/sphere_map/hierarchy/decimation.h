// Decimation of a closed genus-0 mesh to a tetrahedron by half-edge collapses, and the record that undoes it.
//
// Progressive meshes (Hoppe 1996) with quadric errors (Garland and Heckbert 1997). The order matters for the map:
// collapse_costs.h says what makes a step dear. Every collapse keeps the link condition, so every mesh of the sequence
// is a closed manifold of genus 0. Large meshes begin region by region, side by side (regional_decimation.h).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/threads/thread_pool.h"
#include "sphere_map/hierarchy/tie_breaker.h"
#include "sphere_map/hierarchy/vertex_rings.h"

namespace orbicube::sphere_map {

struct Decimation {
  Array<Collapse> collapses;         // in the order in which they were done
  Array<Index> ring_pool;            // what Collapse::ring_begin points into
  std::array<Index, 4> tetrahedron;  // the vertices that are left: one with its ring, in an order given by geometry
  VertexRings rings;                 // at the tetrahedron; split() refines it again

  std::span<const Index> ring(const Collapse& c) const { return {ring_pool.data() + c.ring_begin, c.ring_size}; }
};

// Vertices of a region of a large mesh: enough for the few at its border, which wait, to matter little.
constexpr std::size_t usual_region_size = 50000;

// Decimates `rings`. `positions` should be of unit size. `seed` varies the order of equally good steps. The result
// depends on `region_size`, never on the number of threads. O(n log n) for bounded valence. Throws Error internal if no
// step is possible, which a closed manifold excludes.
Decimation decimate(std::span<const mesh::Vector3> positions, VertexRings rings, std::uint64_t seed,
                    const base::Host& host, const base::ThreadPool& pool, std::size_t region_size = usual_region_size,
                    Ties ties = Ties::by_geometry);

// Numbers the vertices of a decimation again, by their place in its hierarchy: first that of the tetrahedron's first
// vertex and of all that were merged into it, and so on. What refines the decimation then depends on the hierarchy
// alone, not on the numbers that the vertices had, and vertices with near numbers are near each other. Returns the new
// number of each vertex; those in no triangle have the last ones.
Array<Index> renumber(Decimation& decimation, const base::Host& host);

// Sets the directions of the vertices that are left to a regular tetrahedron.
void set_tetrahedron(const std::array<Index, 4>& vertices, std::span<mesh::Vector3> directions);

}  // namespace orbicube::sphere_map
