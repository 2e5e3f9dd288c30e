// Nodes and weights of Gauss-Legendre quadrature on [-1, 1], exact for polynomials of degree 2 count - 1.
#pragma once

#include <span>

namespace orbicube::harmonics {

// nodes from high to low; both spans have one entry a node. Newton's method on the Legendre polynomial. O(count^2).
void gauss_legendre(std::span<double> nodes, std::span<double> weights);

}  // namespace orbicube::harmonics
