#include "harmonics/functions/gauss_legendre.h"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace orbicube::harmonics {

void gauss_legendre(std::span<double> nodes, std::span<double> weights) {
  const std::size_t n = nodes.size();
  for (std::size_t k = 0; 2 * k < n; ++k) {
    // Tricomi's approximation, which Newton's method makes exact in a few steps.
    const double count = static_cast<double>(n);
    double x =
        (1 - 1 / (8 * count * count)) * std::cos(std::numbers::pi * (static_cast<double>(k) + 0.75) / (count + 0.5));
    double slope = 1;
    constexpr int max_steps = 8;
    for (int step = 0; step < max_steps; ++step) {
      double value = 1, before = 0;
      for (std::size_t j = 1; j <= n; ++j) {
        const double d = static_cast<double>(j);
        const double next = ((2 * d - 1) * x * value - (d - 1) * before) / d;
        before = value;
        value = next;
      }
      slope = count * (x * value - before) / (x * x - 1);
      const double change = value / slope;
      x -= change;
      if (std::abs(change) < 1e-16) break;
    }
    if (2 * k + 1 == n) x = 0;
    nodes[k] = x;
    nodes[n - 1 - k] = -x;
    weights[k] = weights[n - 1 - k] = 2 / ((1 - x * x) * slope * slope);
  }
}

}  // namespace orbicube::harmonics
