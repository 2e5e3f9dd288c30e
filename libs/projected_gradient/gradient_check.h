// A gradient against differences of f: what a user looks at when a run stalls.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "base/host.h"
#include "projected_gradient/problem.h"

namespace orbicube::projected_gradient {

struct GradientCheck {
  bool agrees = false;              // every entry that could be compared, within what differences tell
  std::size_t worst = 0;            // the entry with the largest error
  double told = 0, difference = 0;  // of it
  double error = 0;          // |`told` - `difference`| / max(|`told`|, |`difference`|) of it, less the uncertainty
  double uncertainty = 0;    // of the difference, from two steps and the rounding of f
  std::size_t compared = 0;  // entries; the others have no value on either side
  std::size_t evaluations = 0;
};

// f and, where `gradient` is not null, its gradient at x; NaN where f has no value.
using ValueAndGradient = std::function<double(const double* x, double* gradient)>;

// Compares the gradient at x, moved into the bounds of the problem, with differences along the axes that stay within
// them; rows are left out of account. 4 evaluations an unknown, 8 where the first steps do not resolve f. Throws
// invalid-argument when f has no value or gradient at x.
GradientCheck check_gradient(const Problem& problem, std::span<const double> x, const ValueAndGradient& f,
                             const base::Host& host);

}  // namespace orbicube::projected_gradient
