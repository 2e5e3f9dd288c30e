// Coefficients from samples at scattered directions, by weighted least squares (the dissertation's section 3.3.1 takes
// the integral of f Y_lm; on scattered samples its sum is no projection, and diverges as the degree grows).
//
// Minimized is  sum_i w_i |f_i - sum a_lm Y_lm(i)|^2 + regularization (sum_i w_i / 4 pi) sum (l (l + 1))^2 |a_lm|^2,
// the second term being the integral of the squared Laplacian of the fit, times the mean density of the weights.
//
// dense: Householder QR with column pivoting, which sees the rank (householder.h). O(n k^2) for k = (degree + 1)^2.
// iterative: conjugate gradients on the normal equations, whose matrix is known from O(k) moments of the weights and is
// applied in O(degree^3) whatever the number of samples (gram_operator.h); the solution is refined with residuals of
// the samples themselves, so that it is as exact as the samples allow and not only as the normal equations do.
// O(n k + iterations degree^3). How well the samples determine the coefficients is measured with a random right side.
// From degree 80 the same equations are solved for all functions in one preconditioned block (large_fit.h).
#pragma once

#include <cstdint>
#include <span>

#include "harmonics/functions/basis.h"
#include "harmonics/functions/coefficients.h"

namespace orbicube::harmonics {

enum class FitMethod : std::int32_t { automatic = 0, dense = 1, iterative = 2 };

struct FitOptions {
  std::uint32_t degree = 16;
  FitMethod method = FitMethod::automatic;  // dense when n k^2 is at most 5e8 or n < k
  double regularization = 0;                // not negative
};

struct FitReport {
  FitMethod method = FitMethod::dense;  // that was used
  std::size_t unknowns = 0;             // (degree + 1)^2
  // How many combinations of coefficients the samples (and the regularization) determine; fewer than `unknowns` when
  // the fit is rank-deficient, and zero when the iterative method found the fit too ill-conditioned to tell (degree
  // above 40).
  std::size_t rank = 0;
  double condition = 0;          // estimate of the condition of the weighted basis matrix, within the rank
  double residual = 0;           // root of the mean of |f - fit|^2, by weights
  std::uint64_t iterations = 0;  // of the iterative method, all together
};

// `values` are channels numbers a direction; `weights` one a direction, not negative, or empty for ones. Directions of
// weight zero do not matter. A rank-deficient fit returns coefficients of (about) the minimum length among the best:
// look at report.rank. Same bits for any number of threads.
// Throws Error: invalid-argument (sizes, what is not finite, no weight at all; by the automatic method, more unknowns
// than samples without regularization where that would take long), cancelled, out-of-memory.
Coefficients fit(std::span<const Vector3> directions, std::span<const double> weights, std::span<const double> values,
                 std::size_t channels, const FitOptions& options, const base::Host& host, FitReport& report);

}  // namespace orbicube::harmonics
