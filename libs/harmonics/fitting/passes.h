// Passes over the samples that both iterative fits make: the normal equations are solved for what is left of the
// samples until nothing is, so that a fit is as exact as the samples allow and not only as the normal equations do.
#pragma once

#include <cmath>
#include <span>

#include "base/sums.h"
#include "harmonics/fitting/fit_samples.h"
#include "harmonics/functions/basis.h"

namespace orbicube::harmonics {

struct PassLimits {
  int max_passes;
  double enough;  // fraction of the first length of the gradient at which it is 0 but for rounding
};

// `equations` has the penalty; add_solution(right, is_first) adds a solution for a right side to the coefficients and
// returns whether to go on. Throws what these throw, and Error "cancelled".
template <class Equations, class AddSolution>
void fit_in_passes(const FitSamples& samples, const Equations& equations, const PassLimits& limits,
                   Coefficients& coefficients, const AddSolution& add_solution, const base::Host& host) {
  Coefficients right(coefficients.degree, samples.channels, host.memory);
  Array<double> rest(samples.values.begin(), samples.values.end(), host.memory), fitted(rest.size(), host.memory);
  double first = 0, last = 0;
  for (int pass = 0; pass < limits.max_passes; ++pass) {
    analyse(samples.directions, samples.weights, rest, right, "fitting", host);
    equations.add_penalty(coefficients.values, samples.channels, -1, right.values);
    const double length = std::sqrt(base::dot(right.values, right.values));
    if (pass == 0) first = length;
    // Done when the residual is orthogonal to the basis but for rounding, or no longer becomes more so.
    if (length <= limits.enough * first || (pass > 0 && length > 0.5 * last)) break;
    last = length;
    if (!add_solution(right, pass == 0)) break;
    synthesise(coefficients, samples.directions, fitted, host);
    for (std::size_t i = 0; i < rest.size(); ++i)
      rest[i] = samples.values[i] - fitted[i];
  }
}

}  // namespace orbicube::harmonics
