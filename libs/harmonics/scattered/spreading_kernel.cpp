#include "harmonics/scattered/spreading_kernel.h"

#include <cmath>
#include <numbers>

#include "harmonics/functions/gauss_legendre.h"

namespace orbicube::harmonics {
namespace {

constexpr double half_width = 0.5 * static_cast<double>(kernel_width);

}  // namespace

SpreadingKernel::SpreadingKernel(double oversampling)
    // A little less than where the transform of the kernel ends at the frequency that is first folded back.
    : beta_(0.98 * std::numbers::pi * (1 - 0.5 / oversampling) * static_cast<double>(kernel_width)) {
  gauss_legendre(nodes_, values_);
  for (std::size_t j = 0; j < node_count; ++j)
    values_[j] *= half_width * value(half_width * nodes_[j]);
  constexpr std::size_t n = power_count;
  // Interpolation at Chebyshev's nodes; his polynomials are then written in powers.
  std::array<std::array<double, n>, n> chebyshev{};  // [k][power]
  chebyshev[0][0] = chebyshev[1][1] = 1;
  for (std::size_t k = 2; k < n; ++k) {
    for (std::size_t p = 0; p < n; ++p)
      chebyshev[k][p] = (p > 0 ? 2 * chebyshev[k - 1][p - 1] : 0) - chebyshev[k - 2][p];
  }
  std::array<double, n> root, wave;
  for (std::size_t j = 0; j < n; ++j)
    root[j] = std::cos(std::numbers::pi * (static_cast<double>(j) + 0.5) / static_cast<double>(n));
  for (std::size_t line = 0; line < kernel_width / 2; ++line) {
    std::array<double, n> sum{}, sample;
    for (std::size_t j = 0; j < n; ++j)
      sample[j] = value(0.5 * (root[j] + 1) + static_cast<double>(line) - half_width);
    wave.fill(1);
    std::array<double, n> before = root;  // cos(-angle)
    for (std::size_t k = 0; k < n; ++k) {
      double coefficient = 0;
      for (std::size_t j = 0; j < n; ++j) {
        coefficient += sample[j] * wave[j];
        const double next = 2 * root[j] * wave[j] - before[j];
        before[j] = wave[j];
        wave[j] = next;
      }
      for (std::size_t p = 0; p < n; ++p)
        sum[p] += coefficient * (k > 0 ? 2.0 : 1.0) / static_cast<double>(n) * chebyshev[k][p];
    }
    for (std::size_t p = 0; p < n; ++p)
      powers_[p][line] = sum[n - 1 - p];
  }
}

double SpreadingKernel::value(double x) const {
  const double square = 1 - x * x / (half_width * half_width);
  return square <= 0 ? 0 : std::exp(beta_ * (std::sqrt(square) - 1));
}

double SpreadingKernel::transform(double frequency) const {
  // Cosines of multiples would lose digits; the nodes come in pairs with the same value.
  double sum = 0;
  for (std::size_t j = 0; j < node_count / 2; ++j)
    sum += 2 * values_[j] * std::cos(2 * std::numbers::pi * frequency * half_width * nodes_[j]);
  return sum;
}

}  // namespace orbicube::harmonics
