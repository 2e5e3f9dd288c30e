// The exponential of a semicircle, e^(beta (sqrt(1 - (2 x / width)^2) - 1)) for |x| <= width / 2, with which a
// non-uniform Fourier transform spreads points on an oversampled grid (Barnett, Magland, af Klinteberg 2019). It is
// evaluated as a polynomial for each of the `kernel_width` grid lines around a point.
#pragma once

#include <array>
#include <cstddef>

namespace orbicube::harmonics {

// With two grid lines per sample, this width has an error of 1e-15; each line less costs a digit.
inline constexpr std::size_t kernel_width = 16;
using KernelValues = std::array<double, kernel_width>;

class SpreadingKernel {
 public:
  SpreadingKernel();

  // Polynomials of the lines' values in 2 t - 1, highest power first; t in [0, 1] is the distance from width / 2 below
  // the point to the first line.
  static constexpr std::size_t power_count = 20;
  const std::array<KernelValues, power_count>& powers() const { return powers_; }

  // Returns the integral over x of the kernel times cos(2 pi frequency x), frequency in waves per grid line.
  double transform(double frequency) const;

 private:
  static double value(double x);

  std::array<KernelValues, power_count> powers_;
  static constexpr std::size_t node_count = 48;
  std::array<double, node_count> nodes_, weights_;  // of the integral
};

}  // namespace orbicube::harmonics
