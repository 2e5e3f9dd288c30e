// The matrix G = sum w_i y_i y_i' of the normal equations of a weighted fit, y_i the basis functions at point i,
// without its entries and without the points: a product of two basis functions of degree <= L is a sum of those of
// degree <= 2L, so G depends on the points through the moments mu_lm = sum w_i Y_lm(i), l <= 2L, only. With the
// function W = sum mu_lm Y_lm on the sphere,
//
//   (G c)_lm = integral of W(u) (sum c_l'm' Y_l'm'(u)) Y_lm(u) over the sphere,
//
// which a grid of 2L + 1 Gauss-Legendre circles with 4L + 1 points each results without error but rounding. One
// product costs O(L^3) whatever the number of points.
#pragma once

#include <Eigen/Core>
#include <span>

#include "base/host.h"
#include "harmonics/functions/coefficients.h"
#include "harmonics/functions/legendre.h"

namespace orbicube::harmonics {

class GramOperator {
 public:
  // From the moments, of one channel and of degree 2L.
  GramOperator(const Coefficients& moments, const base::Host& host);

  std::uint32_t degree() const { return table_.degree(); }

  // product = G c for `channels` columns at once, in the layout of Coefficients. Not from two threads at once.
  void multiply(std::span<const double> c, std::size_t channels, std::span<double> product);

 private:
  // What one block of circles works in. Matrices have a row for each circle of each channel, one channel after the
  // other, and are kept by columns.
  struct Work {
    Work(std::uint32_t degree, std::size_t width, std::pmr::memory_resource* memory);
    Array<double> orders;  // a column for each of 1, cos phi, sin phi, cos 2 phi, ...
    Array<double> grid;    // a column for each longitude
  };
  using Matrix = Eigen::Map<Eigen::MatrixXd>;

  void multiply_group(std::span<const double> c, std::size_t channels, std::size_t first, std::size_t group,
                      std::span<double> product);
  void multiply_block(std::size_t b, std::size_t group, const PackedCoefficients& packed);
  // Values on the circles of a block, in work.grid, of packed coefficients.
  void to_grid(std::size_t block, const LegendreTable& table, const PackedCoefficients& packed, Work& work) const;

  const base::Host& host_;
  LegendreTable table_;
  std::size_t longitudes_, block_count_;
  Array<Lanes> height_, radius_;  // z and sqrt(1 - z^2) of the circles, in blocks; weight zero past the last
  Array<double> waves_;           // 1, cos phi, sin phi, ... (rows, up to degree 2L) at each longitude (columns)
  Array<double> density_;         // W times the quadrature's weight: block, longitude, circle in the block
  Array<Work> work_;              // one a block
  Array<double> parts_;           // what the circles of each block add to the product
};

}  // namespace orbicube::harmonics
