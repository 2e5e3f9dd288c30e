// Preconditioned conjugate gradients for G X = B with all columns together: each direction serves every column
// (O'Leary 1980, "The block conjugate gradient algorithm"), which takes far fewer products where a few eigenvalues are
// small. Directions are kept orthonormal in the product of G; those that depend on others but for rounding are dropped.
#pragma once

#include "harmonics/fitting/conjugate_gradients.h"

namespace orbicube::harmonics {

// Largest number of columns.
inline constexpr std::size_t max_block = 16;

struct BlockReport {
  std::uint64_t iterations = 0;
  bool converged = false;
};

// X is written, from zero. Ends where |G x - b| <= tolerance[c] |b| of each column c, after max_iterations, or where no
// direction is left (rounding, for a G that is singular): X then is the best of the directions so far.
// `precondition` is a positive definite approximation of the inverse of G.
BlockReport block_conjugate_gradients(const Multiply& multiply, const Multiply& precondition, std::span<const double> b,
                                      std::size_t channels, std::span<const double> tolerance,
                                      std::uint64_t max_iterations, std::span<double> x, const base::Host& host);

}  // namespace orbicube::harmonics
