// The functions up to a degree L on 2 L + 1 Gauss-Legendre circles with at least 4 L + 1 points each, on which products
// of three of them are integrated without error but rounding. The operator "values on the grid, times a density, back
// to coefficients" costs O(L^3): Legendre functions of two circles z and -z together, one order after the other, and a
// Fourier transform along each circle. With the density of a weighted fit it is the matrix of its normal equations
// (gram_operator.h says why); with the inverse of that density, nearly the inverse of the matrix.
// Work is divided by the sizes only, so that results are the same bits for any number of threads.
#pragma once

#include <span>

#include "base/host.h"
#include "harmonics/functions/coefficients.h"
#include "harmonics/functions/legendre.h"
#include "harmonics/scattered/fourier.h"

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
  bool exists(std::size_t group, std::size_t lane) const { return group * fourier_lanes + lane <= table_.degree(); }
  std::size_t longitudes() const { return fourier_.length(); }

  // product = analysis of density times synthesis of c, for `channels` columns in the layout of Coefficients. Not from
  // two threads at once.
  void multiply(const Values& density, std::span<const double> c, std::size_t channels, std::span<double> product);

 private:
  // Circles that the Legendre functions of an order are computed for at once.
  static constexpr std::size_t lanes = 16;

  std::size_t group_count() const { return height_.size() / fourier_lanes; }
  // Room for the spectra of all circles: [order 0, 1, -1, 2, -2, ...][channel][group].
  ComplexLanes* spectrum(std::size_t order, std::size_t channels) {
    return spectra_.data() + order * channels * group_count();
  }
  void synthesize_order(const LegendreTable& table, std::uint32_t m, const double* packed, std::size_t channels,
                        double* column);
  void analyze_order(std::uint32_t m, double* packed, std::size_t channels, double* column);
  void read_spectrum(std::size_t group, std::size_t channel, std::size_t channels, std::uint32_t degree,
                     ComplexLanes* data);
  void synthesize_orders(const LegendreTable& table, std::size_t channels);
  template <class Body>
  void run(std::size_t count, const Body& body) const;

  const base::Host& host_;
  LegendreTable table_;
  FourierTransform fourier_;
  Array<double> height_, radius_, weight_;  // of circles with z >= 0, from the pole; padded
  Array<ComplexLanes> spectra_, work_;
  Array<double> columns_, packed_;  // packed_: [order][channel][degree][cosine, sine]
};

}  // namespace orbicube::harmonics
