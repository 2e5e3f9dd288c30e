#include "harmonics/scattered/spreading_kernel.h"

#include <cmath>
#include <numbers>

#include "harmonics/functions/gauss_legendre.h"

namespace orbicube::harmonics {

SpreadingKernel::SpreadingKernel() {
  gauss_legendre(nodes_, weights_);
  constexpr std::size_t n = power_count;
  // Interpolation at Chebyshev's nodes; his polynomials are then written in powers.
  std::array<std::array<double, n>, n> chebyshev{};  // [k][power]
  chebyshev[0][0] = chebyshev[1][1] = 1;
  for (std::size_t k = 2; k < n; ++k) {
    for (std::size_t p = 0; p < n; ++p)
      chebyshev[k][p] = (p > 0 ? 2 * chebyshev[k - 1][p - 1] : 0) - chebyshev[k - 2][p];
  }
  for (std::size_t line = 0; line < kernel_width; ++line) {
    std::array<double, n> sum{};
    for (std::size_t k = 0; k < n; ++k) {
      double coefficient = 0;
      for (std::size_t j = 0; j < n; ++j) {
        const double angle = std::numbers::pi * (static_cast<double>(j) + 0.5) / static_cast<double>(n);
        const double t = 0.5 * (std::cos(angle) + 1);
        coefficient += (k > 0 ? 2.0 : 1.0) / static_cast<double>(n) *
                       value(t + static_cast<double>(line) - 0.5 * static_cast<double>(kernel_width)) *
                       std::cos(static_cast<double>(k) * angle);
      }
      for (std::size_t p = 0; p < n; ++p)
        sum[p] += coefficient * chebyshev[k][p];
    }
    for (std::size_t p = 0; p < n; ++p)
      powers_[p][line] = sum[n - 1 - p];
  }
}

double SpreadingKernel::value(double x) {
  constexpr double width = static_cast<double>(kernel_width);
  constexpr double beta = 2.3 * width;
  const double square = 1 - 4 * x * x / (width * width);
  return square <= 0 ? 0 : std::exp(beta * (std::sqrt(square) - 1));
}

double SpreadingKernel::transform(double frequency) const {
  constexpr double half = 0.5 * static_cast<double>(kernel_width);
  double sum = 0;
  for (std::size_t j = 0; j < node_count; ++j)
    sum += weights_[j] * half * value(half * nodes_[j]) * std::cos(2 * std::numbers::pi * frequency * half * nodes_[j]);
  return sum;
}

}  // namespace orbicube::harmonics
