// Sums of basis functions at many scattered directions, and their transpose, in O(degree^3 + directions) instead of
// O(degree^2 directions) (Reinecke, Belkner, Carron 2023). Coefficients become values on equidistant circles of
// latitude, those a Fourier series in both angles, and that the values at the directions by a non-uniform Fourier
// transform (spreading_kernel.h). Errors are about 1e-13 of the largest value at degree 1000, less at lower ones. The
// transpose takes the same steps backwards. Work is divided by the sizes only, so that results are the same bits for
// any number of threads.
#pragma once

#include <span>

#include "harmonics/functions/basis.h"
#include "harmonics/scattered/grid_points.h"
#include "harmonics/scattered/order_series.h"
#include "harmonics/scattered/row_series.h"

namespace orbicube::harmonics {

class ScatteredTransform {
 public:
  // `unit`: directions of length 1.
  ScatteredTransform(std::span<const Vector3> unit, std::uint32_t degree, const char* phase, const base::Host& host);

  // Whether this takes less time than the sums themselves. Low degrees are always summed.
  static bool pays(std::size_t directions, std::uint32_t degree);

  // values[i * channels + channel] of one channel of the coefficients.
  void synthesise(const Coefficients& coefficients, std::size_t channel, std::span<double> values);
  // The transpose, of weights[i] values[i * channels + channel]; `weights` may be empty, for ones.
  void analyse(std::span<const double> weights, std::span<const double> values, std::size_t channel,
               Coefficients& coefficients);

 private:
  // What one task works in: the rows that the points of a band reach, and a transform.
  struct Work {
    Array<double> rows;
    Array<ComplexLanes> series;
  };
  template <class Body>
  void run_units(const Body& body);
  void read_unit(const GridUnit& unit, std::size_t channels, double* values, Work& work) const;
  void add_unit(const GridUnit& unit, const double* weights, const double* values, std::size_t channels, Work& work);
  // Rows of a slab and the number from row to row.
  static constexpr std::size_t slab_rows = band_rows + kernel_width;
  std::size_t stride() const { return row_series_.columns() + 2 * grid_margin; }
  bool is_reached(std::ptrdiff_t row) const;

  const char* phase_;
  const base::Host& host_;
  std::size_t rows_;  // of theta from 0 to 2 pi
  SpreadingKernel kernel_;
  OrderSeries order_series_;
  RowSeries row_series_;
  GridPoints points_;
  OrderRows orders_;
  Slots slots_;
  Array<Work> work_;
};

}  // namespace orbicube::harmonics
