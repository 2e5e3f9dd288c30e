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

void gauss_legendre_angles(std::span<long double> angles, std::span<double> weights,
                           const std::function<void()>& pause) {
  const std::size_t n = weights.size();
  const long double count = static_cast<long double>(n);
  for (std::size_t k = 0; 2 * k < n; ++k) {
    constexpr std::size_t nodes_at_once = 64;
    if (k % nodes_at_once == 0) pause();
    long double x = (1 - 1 / (8 * count * count)) *
                    std::cos(std::numbers::pi_v<long double> * (static_cast<long double>(k) + 0.75L) / (count + 0.5L));
    long double slope = 1;
    constexpr int max_steps = 8;
    for (int step = 0; step < max_steps; ++step) {
      long double value = 1, before = 0;
      for (std::size_t j = 1; j <= n; ++j) {
        const long double d = static_cast<long double>(j);
        const long double next = ((2 * d - 1) * x * value - (d - 1) * before) / d;
        before = value;
        value = next;
      }
      slope = count * (x * value - before) / (x * x - 1);
      const long double change = value / slope;
      x -= change;
      // The next step would change less than the rounding; the slope is as exact where nodes are far apart for that.
      if (std::abs(change) < 1e-14L * (1 - x * x)) break;
    }
    if (2 * k + 1 == n) x = 0;
    angles[k] = std::acos(x);
    weights[k] = weights[n - 1 - k] = static_cast<double>(2 / ((1 - x * x) * slope * slope));
  }
}

}  // namespace orbicube::harmonics
