// Nodes and weights of Gauss-Legendre quadrature on [-1, 1], exact for polynomials of degree 2 count - 1.
#pragma once

#include <functional>
#include <span>

namespace orbicube::harmonics {

// nodes from high to low; both spans have one entry a node. Newton's method on the Legendre polynomial. O(count^2).
void gauss_legendre(std::span<double> nodes, std::span<double> weights);

// The same with the angles acos of the nodes from 0 to a right angle, (size + 1) / 2 of them, to the last digit.
// `pause` is called every few milliseconds.
void gauss_legendre_angles(std::span<long double> angles, std::span<double> weights,
                           const std::function<void()>& pause);

}  // namespace orbicube::harmonics
