// Inverted tetrahedra of a mesh untangled: vertices move, some coordinates stay or are tied to each other, until the
// exact sign of every volume is positive. For any mesh of tetrahedra; the method is that of foldover_energy.h.
#pragma once

#include <cstdint>
#include <span>

#include "base/host.h"
#include "volume_map/untangle/block_assembly.h"

namespace orbicube::volume_map {

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

struct UntangleOptions {
  int steps = 500;           // of Newton's method at most in each of three attempts, until no tetrahedron is inverted
  int polish_steps = 20;     // then at most the given number, that lower the distortion and keep all positive
  double volume_weight = 1;  // how much changes of volume count beside those of angles, above 0
  BlockEngine* engine = nullptr;  // of the linear systems; none: this library's own
};

struct Untangled {
  explicit Untangled(std::pmr::memory_resource* memory) : positions(memory) {}

  Array<Vector3> positions;
  std::size_t inverted_before = 0, inverted = 0;  // tetrahedra that are not positive, by exact arithmetic
  Index first_inverted = no_index;
  std::size_t steps = 0, polish_steps = 0;          // taken
  double min_determinant = 0, max_determinant = 0;  // of the map from the target shapes; 1 keeps volumes
  double energy = 0;                                // mean of |J|^2 / D^(2/3) + volume_weight (1 + D^2) / D
};

// Fixed coordinates stay to the bit and tied ones are the same bits. The best that was found where some stay inverted:
// `inverted` says so, see require_untangled. A mesh without inverted tetrahedra is only polished. The same for any
// number of threads. About 500 bytes a tetrahedron.
// Throws Error "index-range", "no-cells", "degenerate-cell" (a repeated vertex, or a target shape that is flat),
// "inverted-cell" (a target shape), "non-manifold-face" and
// "inconsistent-orientation" (three tetrahedra at a face, or two on one side of it), "degenerate-geometry" (all in one
// plane, or of no finite volume), "invalid-argument" for options and for what Variables refuses, "cancelled".
Untangled untangle(const UntangleProblem& mesh, const UntangleOptions& options, const base::Host& host);

// Throws Error "no-valid-result", with how many and the first, when some are inverted.
void require_untangled(const Untangled& result, std::size_t tetrahedra);

// Tetrahedra that are not positive by exact arithmetic, and the first of them.
struct InvertedCount {
  std::size_t count = 0;
  Index first = no_index;
};
InvertedCount count_inverted(std::span<const Tetrahedron> tetrahedra, std::span<const Vector3> positions,
                             const base::Host& host);

}  // namespace orbicube::volume_map
