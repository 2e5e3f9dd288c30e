// Products of two numbers without rounding error, as a sum of two (Dekker 1971, "A floating-point technique for
// extending the available precision"), in plain operations that every vector variant does alike.
#pragma once

#include "base/vector_variants.h"

namespace orbicube::harmonics {

struct TwoParts {
  double high, low;
};

ORBICUBE_INLINE TwoParts split(double a) {
  const double c = 134217729.0 * a;  // 2^27 + 1
  const double high = c - (c - a);
  return {high, a - high};
}

// a b.
ORBICUBE_INLINE TwoParts exact_product(double a, double b) {
  const double p = a * b;
  const TwoParts x = split(a), y = split(b);
  return {p, ((x.high * y.high - p) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

// a b to about 100 bits.
ORBICUBE_INLINE TwoParts product(const TwoParts& a, const TwoParts& b) {
  const TwoParts p = exact_product(a.high, b.high);
  return {p.high, p.low + (a.high * b.low + a.low * b.high)};
}

}  // namespace orbicube::harmonics
