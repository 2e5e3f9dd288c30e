// Inverted tetrahedra of a mesh untangled: vertices move, some coordinates stay or are tied to each other, until the
// exact sign of every volume is positive. For any mesh of tetrahedra; the method is that of foldover_energy.h.
#pragma once

#include <cstdint>
#include <span>

#include "base/host.h"
#include "untangle/untangling.h"

namespace orbicube::untangle {

struct UntangleProblem {
  std::span<const Tetrahedron> tetrahedra;
  std::span<const Vector3> start;  // where vertices are
  // Where the same tetrahedra, all positive, have the shapes that they should have; only shapes count, not the size of
  // the whole. Empty: regular tetrahedra of one size.
  std::span<const Vector3> rest = {};
  // An entry a coordinate each (variables.h), or empty: what stays, and what is equal to what.
  std::span<const std::uint8_t> fixed = {};
  std::span<const Index> ties = {};
};

struct Untangled : UntanglingFigures {
  explicit Untangled(std::pmr::memory_resource* memory) : positions(memory) {}

  Array<Vector3> positions;
};

// Fixed coordinates stay to the bit and tied ones are the same bits. The best that was found where some stay inverted:
// `inverted` says so, see require_untangled. A mesh without inverted tetrahedra is only polished. The same for any
// number of threads. About 500 bytes a tetrahedron.
// Throws Error "index-range", "no-cells", "degenerate-cell" (a repeated vertex, or a target shape that is flat),
// "inverted-cell" (a target shape), "non-manifold-face" and
// "inconsistent-orientation" (three tetrahedra at a face, or two on one side of it), "degenerate-geometry" (all in one
// plane, or of no finite volume), "invalid-argument" for options and for what Variables refuses, "cancelled".
Untangled untangle_tetrahedra(const UntangleProblem& mesh, const UntangleOptions& options, const base::Host& host);

// Throws Error "no-cells", "index-range", or "degenerate-cell" for a repeated vertex.
void require_vertices(std::span<const Tetrahedron> tetrahedra, std::span<const Vector3> positions);

// Counts the tetrahedra that are not positive. Throws Error "cancelled".
InvertedCount count_inverted(std::span<const Tetrahedron> tetrahedra, std::span<const Vector3> positions,
                             const base::Host& host);

}  // namespace orbicube::untangle
