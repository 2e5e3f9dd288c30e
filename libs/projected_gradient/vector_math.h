// What the method does with whole vectors, besides the sums of base/sums.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "base/sums.h"

namespace orbicube::projected_gradient {

using base::all_finite;
using base::blocked_sum;
using base::CompensatedSum;
using base::dot;

inline double max_magnitude(std::span<const double> a) {
  double largest = 0;
  for (const double value : a)
    largest = std::max(largest, std::abs(value));
  return largest;
}

inline double clip(double value, double lower, double upper) {
  return value < lower ? lower : (value > upper ? upper : value);
}

}  // namespace orbicube::projected_gradient
