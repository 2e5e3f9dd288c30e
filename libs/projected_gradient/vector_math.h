// What the method does with whole vectors, besides the sums of base/sums.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
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

// s'y of a step s and a change of gradient y where a quasi-Newton model can take the pair, else 0.
inline double safe_curvature(std::span<const double> s, std::span<const double> y) {
  const double length = dot(s, s), curvature = dot(s, y), change = dot(y, y);
  if (!(length > 0) || !(curvature > std::numeric_limits<double>::epsilon() * change) || !std::isfinite(change))
    return 0;
  return change / curvature < 1e300 ? curvature : 0;
}

}  // namespace orbicube::projected_gradient
