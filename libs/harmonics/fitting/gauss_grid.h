// The functions up to a degree L on 2 L + 1 Gauss-Legendre circles with at least 4 L + 1 points each, on which products
// of three of them are integrated without error but rounding. The operator "values on the grid, times a density, back
// to coefficients" costs O(L^3): Legendre functions of two circles z and -z together, one order after the other, and a
// Fourier transform along each circle. With the density of a weighted fit it is the matrix of its normal equations
// (gram_operator.h says why); with the inverse of that density, nearly the inverse of the matrix.
// Work is divided by the sizes only, so that results are the same bits for any number of threads.
#pragma once

#include <span>

#include "base/host.h"
#include "harmonics/functions/circle_sums.h"
#include "harmonics/functions/coefficients.h"
#include "harmonics/scattered/fourier.h"
#include "harmonics/scattered/slots.h"

namespace orbicube::harmonics {

class GaussGrid {
 public:
  // Numbers on the grid: [group of four pairs of circles][longitude], the circle z as real and -z as imaginary part.
  using Values = Array<ComplexLanes>;

  GaussGrid(std::uint32_t degree, const base::Host& host);

  // Returns the values of a function of one channel, of a degree up to 2 L.
  Values values(const Coefficients& function);
  // Multiplies values with the weights of the quadrature, so that they become a density for multiply().
  void weigh(Values& values) const;
  // Whether the entry at a group, its longitudes and a lane belongs to a circle, and not to the padding.
  bool exists(std::size_t group, std::size_t lane) const { return group * fourier_lanes + lane <= degree_; }
  std::size_t longitudes() const { return fourier_.length(); }

  // product = analysis of density times synthesis of c, for `channels` columns in the layout of Coefficients. Not from
  // two threads at once.
  void multiply(const Values& density, std::span<const double> c, std::size_t channels, std::span<double> product);

 private:
  // Circles that the Legendre functions of an order are computed for at once.
  static constexpr std::size_t lanes = 2 * circle_group;
  // What one task works in.
  struct Work {
    OrderRecurrence recurrence;
    Array<double> column;
  };

  std::size_t group_count() const { return pairs_.padded() / fourier_lanes; }
  // Room for the spectra of all circles: [order 0, 1, -1, 2, -2, ...][channel][group].
  ComplexLanes* spectrum(std::size_t order, std::size_t channels) {
    return spectra_.data() + order * channels * group_count();
  }
  const double* power(std::uint32_t exponent) const { return powers_.data() + exponent * pairs_.padded(); }
  void synthesize_order(Work& work, std::uint32_t m, double* packed, std::size_t channels);
  void analyze_order(Work& work, std::uint32_t m, double* packed, std::size_t channels);
  void read_spectrum(std::size_t group, std::size_t channel, std::size_t channels, std::uint32_t degree,
                     ComplexLanes* data);
  void synthesize_orders(Array<Work>& work, std::uint32_t degree, std::size_t channels);
  Array<Work> make_work(std::uint32_t degree, std::size_t channels);

  const base::Host& host_;
  std::uint32_t degree_;
  FourierTransform fourier_;
  CirclePairs pairs_;     // from the pole, padded
  Array<double> weight_;  // of the circles
  Array<double> powers_;  // of the radii: [exponent up to L][pair]
  Slots slots_;
  Array<ComplexLanes> spectra_, series_;
  Array<Work> work_;
  std::size_t work_channels_ = 0;
  Array<double> packed_;  // [order][channel][degree][cosine, sine]
};

}  // namespace orbicube::harmonics
