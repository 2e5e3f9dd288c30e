// What the coefficients say of each degree, whichever way the sphere is turned: a rotation mixes the coefficients of a
// degree among themselves and keeps the sum of their squares (the dissertation's section 3.3.3).
#pragma once

#include <cstdint>
#include <span>

#include "harmonics/functions/coefficients.h"

namespace orbicube::harmonics {

// energies[l] = |f_l| = sqrt(sum over m and the channels of a_lm^2): the L2 norm of the part of degree l. Of the three
// coordinates of a shape together, so that turning the shape in space changes nothing either.
void degree_norms(const Coefficients& coefficients, std::span<double> norms);

// D_n(f, g) = sum over l from `first` to `last` of (|f_l| - |g_l|)^2, where degrees that one of the two does not have
// count as zero. The dissertation's sum starts at 0; from 1 on, where a shape lies does not matter.
double shape_distance(const Coefficients& f, const Coefficients& g, std::uint32_t first, std::uint32_t last);

// Which degrees a filter keeps: factor 1 from `low` to `high`, 0 elsewhere, with a raised cosine of `width` degrees
// outside each end (0: none), which rings less on a surface than a sharp cut.
struct Band {
  std::uint32_t low = 0, high = largest_degree;
  std::uint32_t width = 0;
};
double band_factor(const Band& band, std::uint32_t l);

// Multiplies the coefficients of each degree by its factor. keep_mean leaves degree 0 as it is, which for the
// coordinates of a shape is where it lies.
void filter(Coefficients& coefficients, const Band& band, bool keep_mean);

}  // namespace orbicube::harmonics
