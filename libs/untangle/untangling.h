// Options and figures of both functions of this library: untangle_triangles and untangle_tetrahedra.
#pragma once

#include <cstddef>
#include <string>

#include "linear/iterative/block_engine.h"
#include "untangle/types.h"

namespace orbicube::untangle {

using BlockEngine = linear::BlockEngine<3>;

struct UntangleOptions {
  int steps = 500;           // of Newton's method at most in each of the attempts, until no element is inverted
  int polish_steps = 20;     // then at most the given number, that lower the distortion and keep all positive
  double volume_weight = 1;  // how much changes of volume or area count beside those of angles, above 0
  double tolerance = 1e-4;   // a polishing step that lowers the energy by less than this fraction of it is the last one
  BlockEngine* engine = nullptr;  // of the linear systems of tetrahedra; none: the library `linear`
};

struct UntanglingFigures {
  std::size_t inverted_before = 0, inverted = 0;  // elements that are not positive, by exact arithmetic
  Index first_inverted = no_index;
  std::size_t steps = 0, polish_steps = 0;          // taken
  double min_determinant = 0, max_determinant = 0;  // of the map from the target shapes; 1 keeps volumes
  double energy = 0;  // mean of |J|^2 / D^(2/d) + volume_weight (1 + D^2) / D in d dimensions
};

// Elements that are not positive by exact arithmetic, and the first of them.
struct InvertedCount {
  std::size_t count = 0;
  Index first = no_index;
};

// Throws Error "invalid-argument" for options out of their ranges.
void require_valid(const UntangleOptions& options);

// Throws Error "no-valid-result", with how many and the first, when some of the elements, `count` "tetrahedra" or
// "triangles", are inverted.
void require_untangled(const UntanglingFigures& figures, std::size_t count, const char* one, const char* many);

}  // namespace orbicube::untangle
