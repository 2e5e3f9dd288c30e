// The iterative fit of high degrees: the normal equations as a product on a grid (gauss_grid.h), all functions in one
// block of conjugate gradients, preconditioned by the inverse of the density of the weights.
//
// Where the samples are dense, G is nearly the product with their density W, smoothed to the wavelength of the degree,
// so its inverse is nearly the product with 1 / W. What is left are gaps between samples that are longer than half a
// wavelength: each adds a few small eigenvalues, of which a block of columns finds that number at a time. One of the
// columns is a random right side, which measures the condition.
#pragma once

#include "harmonics/fitting/fit_samples.h"

namespace orbicube::harmonics {

// Degrees below are fitted with the matrix of gram_operator.h.
inline constexpr std::uint32_t large_fit_degree = 80;

// Fits, unless sums and the matrix of low degrees take less time, or this is not built in (the module of WebAssembly):
// then returns false with nothing done.
bool fit_large(const FitSamples& samples, const FitOptions& options, const base::Host& host, Coefficients& coefficients,
               FitReport& report);

}  // namespace orbicube::harmonics
