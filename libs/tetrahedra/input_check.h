// Whether a surface can be filled: decided exactly and completely before TetGen runs, which would fail in ways of its
// own.
#pragma once

#include <array>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::tetrahedra {

// Throws Error unless the triangles are closed manifold surfaces of triangles with area that nowhere meet themselves or
// each other: "invalid-argument" (index out of range, not finite), "empty-mesh", "degenerate-geometry",
// "degenerate-face", "duplicate-face", "non-manifold-edge", "not-closed", "non-manifold-vertex", "non-orientable",
// "self-intersection", each with how many and the first place; "cancelled". O(n log n).
void require_fillable(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                      const base::Host& host);

using FacePair = std::array<mesh::Index, 2>;

// The same without the last requirement, and the pairs of triangles that break it: the lower one first, ascending.
mesh::Array<FacePair> self_intersections(std::span<const mesh::Vector3> positions,
                                         std::span<const mesh::Triangle> triangles, const base::Host& host);

// The last requirement.
void require_none(std::span<const FacePair> self_intersections);

}  // namespace orbicube::tetrahedra
