// Decimation of a closed genus-0 mesh to a tetrahedron by half-edge collapses, and the record that undoes it.
//
// Progressive meshes (Hoppe 1996) with quadric errors (Garland and Heckbert 1997). The order matters for the map:
// slivers and vertices of valence 3 make spherical kernels thin, so both cost extra, as do turned normals and high
// valences. Every collapse keeps the link condition, so every mesh of the sequence is a closed manifold of genus 0.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/team.h"
#include "sphere_map/vertex_rings.h"

namespace orbicube::sphere_map {

struct Decimation {
  Array<Collapse> collapses;         // in the order in which they were done
  Array<Index> ring_pool;            // what Collapse::ring_begin points into
  std::array<Index, 4> tetrahedron;  // the vertices that are left: the first three of the ring of the first
  VertexRings rings;                 // at the tetrahedron; split() refines it again

  std::span<const Index> ring(const Collapse& c) const { return {ring_pool.data() + c.ring_begin, c.ring_size}; }
};

// Decimates `rings`. `positions` should be of unit size. `seed` varies the order of equally good steps.
// O(n log n) for bounded valence. Throws Error internal if no step is possible, which a closed manifold excludes.
Decimation decimate(std::span<const mesh::Vector3> positions, VertexRings rings, std::uint64_t seed,
                    const base::Host& host, const base::Team& team);

}  // namespace orbicube::sphere_map
