// Between the values of c_m - i s_m on circles of latitude and values at equidistant longitudes, eight circles at a
// time: two real rows in one complex transform, four transforms in the lanes. Rows beyond a pole go on as those on the
// other side, half a turn further, where odd orders have the opposite sign.
#pragma once

#include "harmonics/scattered/order_series.h"

namespace orbicube::harmonics {

inline constexpr std::size_t rows_at_once = 2 * fourier_lanes;

class RowSeries {
 public:
  RowSeries(std::uint32_t degree, std::size_t columns, const SpreadingKernel& kernel, const base::Host& host);

  std::size_t columns() const { return transform_.length(); }
  // What synthesise() and analyse() work in: this number of entries.
  std::size_t work_size() const { return 2 * transform_.length(); }

  // Writes rows first, first + 1, ..., `stride` numbers apart, with `margin` columns on both sides: `to` is the place
  // of column 0 of the first row.
  void synthesise(const OrderRows& orders, std::ptrdiff_t first, std::size_t margin, std::size_t stride, double* to,
                  ComplexLanes* work) const;
  // The transpose: adds to the rows of `orders`. The margins of `from` are changed.
  void analyse(double* from, std::ptrdiff_t first, std::size_t margin, std::size_t stride, OrderRows& orders,
               ComplexLanes* work) const;

 private:
  // Where the rows are, and the signs of the odd orders.
  struct Sources {
    std::array<std::size_t, rows_at_once> row;
    std::array<double, rows_at_once> sign;
  };
  static Sources sources(std::ptrdiff_t first, std::size_t row_count);

  std::uint32_t degree_;
  FourierTransform transform_;
  Array<double> factor_;  // by order, padded to whole groups
};

}  // namespace orbicube::harmonics
