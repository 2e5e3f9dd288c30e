// Between coefficients and, for each order m, the values of c_m - i s_m on equidistant circles of latitude, more of
// them than the degree needs: Legendre sums on the fewest circles, a Fourier transform in theta, factors that undo what
// the interpolation between the circles will do, and a transform back to more circles.
//
// The series of an even order is even in theta, that of an odd order odd. So both of a pair m, m + 1 go through the
// transforms as their sum, and four pairs at once in the lanes.
#pragma once

#include "harmonics/functions/circle_sums.h"
#include "harmonics/scattered/fourier.h"
#include "harmonics/scattered/slots.h"
#include "harmonics/scattered/spreading_kernel.h"

namespace orbicube::harmonics {

inline constexpr std::size_t orders_at_once = 2 * fourier_lanes;

// c_m - i s_m by [group of orders][row][0: even, 1: odd order][lane].
struct OrderRows {
  OrderRows(std::uint32_t degree, std::size_t rows, std::pmr::memory_resource* memory)
      : row_count(rows), group_count(degree / orders_at_once + 1), values(2 * rows * group_count, memory) {}
  ComplexLanes* at(std::size_t group, std::size_t row) { return values.data() + 2 * (group * row_count + row); }
  const ComplexLanes* at(std::size_t group, std::size_t row) const {
    return values.data() + 2 * (group * row_count + row);
  }

  std::size_t row_count, group_count;
  Array<ComplexLanes> values;
};

class OrderSeries {
 public:
  // `rows`: of theta from 0 to 2 pi, half of them and one in OrderRows.
  OrderSeries(std::uint32_t degree, std::size_t rows, const SpreadingKernel& kernel, const base::Host& host);

  // One channel of the coefficients.
  void synthesise(const Coefficients& coefficients, std::size_t channel, const char* phase, OrderRows& rows);
  // The transpose. Writes the channel.
  void analyse(const OrderRows& rows, std::size_t channel, const char* phase, Coefficients& coefficients);

 private:
  // What one task works in.
  struct Work {
    Work(std::uint32_t degree, std::size_t pairs, std::size_t series, std::pmr::memory_resource* memory);
    CircleSums circle_sums();

    OrderRecurrence recurrence;
    Array<double> coefficients;  // [order of the group][degree][cosine, sine]
    Array<double> packed, lanes, sums, power_rest;
    // Of the radii: half the first order of a group, and the next four exponents. An order m starts with the power of
    // m / 2, the rest comes last.
    Array<double> powers;
    Array<ComplexLanes> one, other;
  };

  void read_coefficients(const Coefficients& coefficients, std::size_t channel, std::uint32_t first, Work& work) const;
  void write_coefficients(const Work& work, std::size_t channel, std::uint32_t first, Coefficients& coefficients) const;
  void circles_of_order(Work& work, std::uint32_t m) const;
  void order_of_circles(Work& work, std::uint32_t m, const ComplexLanes* circles) const;
  // An order on circles: its lane, the sign of what it has beyond the pole, and the pairs of circles that it reaches
  // with the powers of their radii that its recurrence starts with and ends with.
  struct OnCircles {
    std::size_t length, half, lane;
    double parity;
    const double *start, *end;
    std::size_t first;
  };
  OnCircles begin_order(Work& work, std::uint32_t m) const;
  const double* power(const Work& work, std::uint32_t m, std::uint32_t half) const;
  ComplexLanes* resize(const ComplexLanes* from, std::size_t length, ComplexLanes* to, std::size_t to_length) const;

  const base::Host& host_;
  std::uint32_t degree_;
  FourierTransform circle_transform_, row_transform_;
  CirclePairs pairs_;
  Array<double> factor_;  // by frequency
  Slots slots_;
  Array<Work> work_;
};

}  // namespace orbicube::harmonics
