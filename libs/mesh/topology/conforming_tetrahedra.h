// Whether tetrahedra meet in whole faces, two at each: by the faces of all, sorted. Works for inverted ones as well.
#pragma once

#include <cstdint>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// A face of a tetrahedron by ascending vertices, and whether these are an odd permutation of it as seen from outside.
struct SortedFace {
  Triangle corners;
  Index tetrahedron;
  bool odd;
};

// Returns the faces of all tetrahedra by their corners, then by the number of the tetrahedron. Throws Error
// "index-range", "cancelled". O(n log n).
Array<SortedFace> sorted_faces(std::span<const Tetrahedron> tetrahedra, std::size_t vertices, const base::Host& host);

// Throws Error unless tetrahedra meet in whole faces, two at each, on its two sides when both are positive:
// "index-range", "non-manifold-face", "inconsistent-orientation", with the numbers of the first place and its
// coordinates; "cancelled". Inverted ones are fine. O(n log n).
void require_conforming(std::span<const Tetrahedron> tetrahedra, std::span<const Vector3> positions,
                        const base::Host& host);

// Returns an entry a vertex, 1 where it lies on a face of one tetrahedron alone. Throws Error "index-range",
// "cancelled". O(n log n).
Array<std::uint8_t> boundary_vertices(std::span<const Tetrahedron> tetrahedra, std::size_t vertices,
                                      const base::Host& host);

}  // namespace orbicube::mesh
