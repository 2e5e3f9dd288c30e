// Conjugate gradients for G x = b with several right sides at once (Hestenes and Stiefel 1952), and what they report
// the eigenvalues of G: the coefficients of the method are those of Lanczos's tridiagonal matrix.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "base/array.h"
#include "base/host.h"

namespace orbicube::harmonics {

// product = G x for vectors of `channels` interleaved columns.
using Multiply = std::function<void(std::span<const double> x, std::size_t channels, std::span<double> product)>;

struct ConjugateGradientsOptions {
  double tolerance = 1e-8;  // of |G x - b| relative to |b|, for each column
  std::uint64_t max_iterations = 1000;
  const char* phase = "solving";
};

struct ConjugateGradientsReport {
  std::uint64_t iterations = 0;
  double residual = 0;               // largest |G x - b| / |b| over the columns, by the recurrence
  bool singular = false;             // whether G was not positive in a direction of search
  double smallest = 0, largest = 0;  // eigenvalues of G as the first column saw them (zeros when it is zero)
};

// x is written, from zero. Stops at the tolerance, at max_iterations, or where G is not positive in the direction of
// search (rounding, for a G that is singular): the columns then keep what they have.
ConjugateGradientsReport conjugate_gradients(const Multiply& multiply, std::span<const double> b, std::size_t channels,
                                             std::span<double> x, const ConjugateGradientsOptions& options,
                                             const base::Host& host);

}  // namespace orbicube::harmonics
