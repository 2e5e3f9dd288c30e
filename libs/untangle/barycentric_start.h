// A start that depends on fixed coordinates alone: each free one is the mean of those at the other ends of its edges
// (Tutte 1963, "How to draw a graph"). Untangling reaches maps from there that it does not from a scrambled start.
#pragma once

#include <span>

#include "base/host.h"
#include "untangle/tetrahedra/variables.h"
#include "untangle/types.h"

namespace orbicube::untangle {

// Replaces the free ones of `values`, an entry a variable. Returns false, and leaves them as they are, where nothing is
// fixed or the system is not solved to a relative residual of 1e-6. The same for any number of threads. Linear time.
// About 500 bytes an element. Variables are coordinates, without signs or shifts. Throws Error "cancelled".
bool start_barycentric(std::span<const Triangle> triangles, const Variables& variables, std::span<double> values,
                       const base::Host& host);
bool start_barycentric(std::span<const Tetrahedron> tetrahedra, const Variables& variables, std::span<double> values,
                       const base::Host& host);

}  // namespace orbicube::untangle
