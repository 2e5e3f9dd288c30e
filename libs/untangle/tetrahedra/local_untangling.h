// Inverted elements untangled each in its neighborhood. Where they are few among many, a step for the whole mesh
// costs what a hundred for their neighborhoods do; what is far from them hardly moves either way.
#pragma once

#include "untangle/tetrahedra/foldover_energy.h"

namespace orbicube::untangle {

struct LocalUntangling {
  explicit LocalUntangling(std::pmr::memory_resource* memory) : jammed(memory) {}

  bool done = false;      // no element is inverted, in floating point
  std::size_t steps = 0;  // of Newton's method, of all neighborhoods together
  // An entry a vertex, 1 for those of elements that stayed inverted when the neighborhood moved. Empty when done, and
  // where no neighborhood was tried.
  Array<std::uint8_t> jammed;
};

// Moves vertices within some rings of neighbors of each group of elements that are not positive, by the method of
// newton.h with all else fixed, and lets the distortion there fall; then those within twice as many rings round what is
// left, at most three times, and only as long as these are less than half of all vertices. A group that is not
// untangled stays as it was. `fixed` has an entry a coordinate, not 0 for what stays. At most `max_steps` steps, and
// 150, are made in each neighborhood. `pulls` has what pulls each vertex besides, or nothing (foldover_energy.h). The
// same for any number of threads. About 100 bytes an element, and 600 for those of a neighborhood. Throws Error
// "cancelled".
LocalUntangling untangle_locally(std::span<const Element> elements, std::span<const std::uint8_t> fixed, double lambda,
                                 int max_steps, std::span<Vector3> positions, const base::Host& host,
                                 std::span<const Pull> pulls = {});

}  // namespace orbicube::untangle
