// The exponential of a semicircle, e^(beta (sqrt(1 - (2 x / width)^2) - 1)) for |x| <= width / 2, with which a
// non-uniform Fourier transform spreads points on an oversampled grid (Barnett, Magland, af Klinteberg 2019). It is
// evaluated as a polynomial for each of the `kernel_width` grid lines around a point.
#pragma once

#include <array>
#include <cstddef>

namespace orbicube::harmonics {

// With 1.8 grid lines per sample, this width has an error of 7e-14 at the highest frequency, and of 2e-14 in the mean;
// each line less costs a digit.
inline constexpr std::size_t kernel_width = 16;
using KernelValues = std::array<double, kernel_width>;

class SpreadingKernel {
 public:
  // `oversampling`: grid lines per sample, above 1.
  explicit SpreadingKernel(double oversampling);

  // For a point at t in [0, 1] grid lines less than width / 2 above the first line, lines k and width - 1 - k have the
  // values a + b and a - b: a the polynomial of even, b that of odd powers of 2 t - 1. Coefficients of the lower half
  // of the lines, highest power first.
  static constexpr std::size_t power_count = 20;
  using HalfValues = std::array<double, kernel_width / 2>;
  using Powers = std::array<HalfValues, power_count>;
  const Powers& powers() const { return powers_; }

  // Returns the integral over x of the kernel times cos(2 pi frequency x), frequency in waves per grid line.
  double transform(double frequency) const;

 private:
  double value(double x) const;

  double beta_;
  Powers powers_;
  static constexpr std::size_t node_count = 48;
  std::array<double, node_count> nodes_, values_;  // of the integral, kernel and weight multiplied
};

}  // namespace orbicube::harmonics
