// Flipped triangles of a flat mesh untangled: vertices move in the plane, some coordinates stay or are tied to each
// other, until the exact sign of every area is positive. For any triangles; the method is that of planar_newton.h.
#pragma once

#include <cstdint>
#include <span>

#include "base/host.h"
#include "untangle/triangles/planar_triangles.h"
#include "untangle/untangling.h"

namespace orbicube::untangle {

struct TriangleProblem {
  std::span<const Triangle> triangles;
  std::span<const Vector2d> start;  // where vertices are
  // Where the same triangles have their target shapes, in the plane or in space, as of a surface whose map to the plane
  // `start` is; only shapes count, not the size of the whole. Empty: equilateral triangles of one size.
  std::span<const Vector3> rest = {};
  // An entry a coordinate, 2 vertex + axis, or empty: what stays, and what is equal to what (variables.h).
  std::span<const std::uint8_t> fixed = {};
  std::span<const Index> ties = {};
};

struct UntangledTriangles : UntanglingFigures {
  explicit UntangledTriangles(std::pmr::memory_resource* memory) : positions(memory) {}

  Array<Vector2d> positions;
};

// Fixed coordinates stay to the bit and tied ones are the same bits. The best that was found where some stay flipped:
// `inverted` says so, see require_untangled. A mesh without flipped triangles is only polished. The same for any number
// of threads. About 900 bytes a triangle, and a sparse factor.
// Throws Error "index-range", "no-cells", "degenerate-face" (a repeated vertex, or a target shape without area),
// "non-manifold-edge" and "inconsistent-orientation" (three triangles at an edge, or two on one side of it),
// "degenerate-geometry" (no area, or one that is not finite), "invalid-argument" for options and for what Variables
// refuses, "cancelled".
UntangledTriangles untangle_triangles(const TriangleProblem& mesh, const UntangleOptions& options,
                                      const base::Host& host);

// Counts the triangles that are not positive. Throws Error "cancelled".
InvertedCount count_inverted(std::span<const Triangle> triangles, std::span<const Vector2d> positions,
                             const base::Host& host);

// Returns an entry a vertex, 1 where it lies on an edge of one triangle alone. Throws Error "no-cells", "index-range",
// "degenerate-face" for a repeated vertex, "non-manifold-edge", "inconsistent-orientation", "cancelled". O(n log n).
Array<std::uint8_t> boundary_vertices(std::span<const Triangle> triangles, std::size_t vertices,
                                      const base::Host& host);

}  // namespace orbicube::untangle
