// Sums of basis functions at many scattered directions, and their transpose, in O(degree^3 + directions) instead of
// O(degree^2 directions) (Reinecke, Belkner, Carron 2023). Coefficients become values on equidistant circles of
// latitude, those a Fourier series in both angles, and that the values at the directions by a non-uniform Fourier
// transform (spreading_kernel.h). Errors are about 1e-14 of the largest value. The transpose takes the same steps
// backwards. Work is divided by the sizes only, so that results are the same bits for any number of threads.
#pragma once

#include <algorithm>
#include <span>

#include "harmonics/functions/basis.h"
#include "harmonics/scattered/fourier.h"
#include "harmonics/scattered/spreading_kernel.h"

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
  // Grid coordinates of a direction, which come in the order of their tiles.
  struct Point {
    double row, column;
    std::size_t index;
  };
  enum class Way { synthesis, analysis };

  void sort_points(std::span<const Vector3> unit);
  void transform_orders(Way way, PackedCoefficients& packed);
  void transform_order_group(Way way, std::uint32_t first, PackedCoefficients& packed, ComplexLanes* data);
  void circles_of_order(std::uint32_t m, std::size_t lane, const PackedCoefficients& packed,
                        ComplexLanes* circles) const;
  void order_of_circles(std::uint32_t m, std::size_t lane, const ComplexLanes* circles,
                        PackedCoefficients& packed) const;
  void transform_rows(Way way);
  void rows_of_orders(std::size_t first, ComplexLanes* data) const;
  void orders_of_rows(std::size_t first, const ComplexLanes* data);
  void write_rows(std::size_t first, const ComplexLanes* data);
  void read_rows(std::size_t first, ComplexLanes* data);
  void pad_grid();
  void fold_grid();
  void interpolate(std::size_t channels, std::size_t channel, std::span<double> values);
  void spread(std::span<const double> weights, std::span<const double> values, std::size_t channels,
              std::size_t channel);

  double* grid_row(std::ptrdiff_t row) { return grid_.data() + (row + pad) * width_ + pad; }
  // What one task works in: two series.
  ComplexLanes* work(std::size_t slot) {
    return work_.data() + 2 * slot * std::max(row_transform_.length(), circle_transform_.length());
  }
  std::ptrdiff_t last_row() const { return static_cast<std::ptrdiff_t>(row_count_) - 1; }

  static constexpr std::ptrdiff_t pad = kernel_width / 2 + 1;

  const char* phase_;
  const base::Host& host_;
  LegendreTable table_;
  SpreadingKernel kernel_;
  FourierTransform circle_transform_, row_transform_, column_transform_;  // 2 N circles; theta; phi
  std::size_t row_count_;                                                 // of theta from 0 to pi
  std::ptrdiff_t width_;                                                  // of a row with its margins
  Array<Lanes> height_, radius_;                                          // of circles, in blocks
  Array<double> row_factor_, column_factor_;                              // that undo the kernel, by frequency
  Array<ComplexLanes> orders_;  // [group of orders][row]: c_m - i s_m on the oversampled rows
  Array<double> grid_;          // rows from -pad to row_count_ - 1 + pad
  Array<ComplexLanes> work_;
  Array<Point> points_;
  Array<std::size_t> band_start_;
};

}  // namespace orbicube::harmonics
