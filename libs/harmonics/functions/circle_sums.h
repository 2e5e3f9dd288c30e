// Sums over the degrees of one order m at pairs of circles of latitude z and -z, and their transpose.
//
// With R_l = Q_lm / g_l (legendre.h has Q_lm) and g_l = g_l-2 a_l / a_l-1 the recurrence has one factor only,
//
//   R_l = s_l z R_l-1 - R_l-2,  s_l = a_l g_l-1 / g_l,
//
// and g_l is multiplied with the coefficients. Functions of even l - m are the same at z and -z, those of odd l - m
// have the opposite sign. Near the pole this recurrence loses digits, as z does: there it is written in differences
// from what it would be at the pole (Reinsch's form; Gentleman 1969), with 1 - z = 2 sin^2(theta / 2),
//
//   D_l = D_l-1 / r_l-1 - s_l (1 - z) R_l-1,  R_l = r_l R_l-1 + D_l,  r_l = R_l(1) / R_l-1(1).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>

#include "harmonics/functions/coefficients.h"

namespace orbicube::harmonics {

// Circles are worked on in groups of this number.
inline constexpr std::size_t circle_group = 8;

// The recurrence of one order, indexed by l - m.
class OrderRecurrence {
 public:
  OrderRecurrence(std::uint32_t degree, std::pmr::memory_resource* memory);

  void set_order(std::uint32_t m);
  std::size_t count() const { return degree_ + std::size_t{1} - order_; }
  std::uint32_t order() const { return order_; }
  std::uint32_t degree() const { return degree_; }

  const double* steps() const { return step_.data(); }
  const double* scales() const { return scale_.data(); }  // g_l Q_mm
  const double* growths() const { return growth_.data(); }
  const double* shrinkings() const { return shrinking_.data(); }

 private:
  std::uint32_t degree_, order_ = 0;
  Array<double> first_;  // Q_mm by m
  Array<double> factor_, step_, scale_, growth_, shrinking_;
};

// Sums of even and odd l - m, of the coefficients of cosine and sine: one number a circle.
struct CircleSums {
  double *even_cosine, *even_sine, *odd_cosine, *odd_sine;
};

class CirclePairs {
 public:
  // Room for pairs whose angles from the pole, of at most a right angle, set() is given in ascending order.
  CirclePairs(std::size_t pairs, std::pmr::memory_resource* memory);
  void set(std::size_t pair, long double angle);

  std::size_t size() const { return count_; }
  std::size_t padded() const { return height_.size(); }  // a multiple of circle_group

  // First of the pairs, a multiple of circle_group, where functions of the order are not negligible.
  std::size_t first_pair(std::uint32_t m, std::uint32_t degree) const;

  // Writes radius^k for the pairs from `first` and k = exponent, exponent + 1, ..., `count` of them padded() numbers
  // apart. `rest` has room for padded() numbers.
  void powers(std::uint32_t exponent, std::size_t count, std::size_t first, double* high, double* rest) const;

  // Writes sums for the pairs from `first`, of functions whose first one has the value `start` at each pair in place of
  // radius^m: with radius^(m / 2), no value leaves the range of double up to degree 2000. `packed`: for each degree
  // g_l C_lm and g_l S_lm.
  void synthesise(const OrderRecurrence& recurrence, const double* packed, const double* start, std::size_t first,
                  CircleSums sums) const;
  // The transpose: writes coefficients, to be multiplied with g_l. `lanes` has room for 2 circle_group numbers a
  // degree.
  void analyse(const OrderRecurrence& recurrence, CircleSums sums, const double* start, std::size_t first,
               double* lanes, double* packed) const;

  // The functions themselves at two groups of circles: 2 circle_group numbers a degree. `first`: a multiple of that.
  void columns(const OrderRecurrence& recurrence, const double* start, std::size_t first, double* column) const;

 private:
  bool is_polar(std::size_t first, std::size_t count) const;

  std::size_t count_;
  Array<double> height_, depth_;        // z and 1 - z
  Array<double> radius_, radius_rest_;  // sin theta in two parts
};

}  // namespace orbicube::harmonics
