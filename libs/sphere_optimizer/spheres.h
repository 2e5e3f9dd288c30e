// Geometry of a product of unit spheres, block by block: tangent vectors, moves along great circles, and parallel
// transport. All of it is written for a dimension that is either a number of the program or known to the compiler
// (with_dimension), which then unrolls the loops.
#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>

#include "base/sums.h"

namespace orbicube::sphere_optimizer {

template <std::size_t d>
using FixedDimension = std::integral_constant<std::size_t, d>;

// body(dimension) with the usual dimensions known to the compiler.
template <class Body>
decltype(auto) with_dimension(std::size_t dimension, const Body& body) {
  switch (dimension) {
    case 2:
      return body(FixedDimension<2>{});
    case 3:
      return body(FixedDimension<3>{});
    case 4:
      return body(FixedDimension<4>{});
    default:
      return body(dimension);
  }
}

template <class Dimension>
double block_dot(Dimension d, const double* a, const double* b) {
  double sum = 0;
  for (std::size_t k = 0; k < d; ++k)
    sum += a[k] * b[k];
  return sum;
}

// Sum of squares to half a unit of the last place or so in any dimension: what lengths need to be 1 to the last bits.
template <class Dimension>
double block_square(Dimension d, const double* a) {
  if constexpr (!std::is_same_v<Dimension, std::size_t>) {
    if constexpr (Dimension::value == 4) return (a[0] * a[0] + a[1] * a[1]) + (a[2] * a[2] + a[3] * a[3]);
    return block_dot(d, a, a);
  } else {
    base::CompensatedSum sum;
    for (std::size_t k = 0; k < d; ++k)
      sum.add(a[k] * a[k]);
    return sum.value();
  }
}

// a scaled to length 1, to within 2 units of the last place. False, and a unchanged, when it is zero or not finite, or
// so long or short that its square is.
template <class Dimension>
bool normalize(Dimension d, double* a) {
  const double length = std::sqrt(block_square(d, a));
  if (!(length > 1e-150 && length < 1e150)) return false;
  for (std::size_t k = 0; k < d; ++k)
    a[k] /= length;
  return true;
}

// v loses its part along the unit vector x, which is returned.
template <class Dimension>
double make_tangent(Dimension d, const double* x, double* v) {
  const double along = block_dot(d, x, v);
  for (std::size_t k = 0; k < d; ++k)
    v[k] -= along * x[k];
  return along;
}

// Follows the great circle from x (unit) along `direction` (tangent) by `length` times the direction's length, in
// radians, to `out`. `velocity` becomes the direction transported there.
template <class Dimension>
void move(Dimension d, const double* x, const double* direction, double length, double* out, double* velocity) {
  const double speed = std::sqrt(block_dot(d, direction, direction));
  const double angle = length * speed;
  const double cosine = std::cos(angle), sine = std::sin(angle);
  // sin(angle) / speed, also for a direction that is almost or quite nothing.
  const double across = speed > 0 ? sine / speed : 0.0;
  for (std::size_t k = 0; k < d; ++k) {
    const double from = x[k], along = direction[k];
    out[k] = cosine * from + across * along;
    velocity[k] = cosine * along - sine * speed * from;
  }
  normalize(d, out);
}

// Parallel transport of the tangent vector v from p to q along the shorter great circle, which keeps lengths and
// angles.
template <class Dimension>
void transport(Dimension d, const double* p, const double* q, double* v) {
  double along = 0, together = 1;
  for (std::size_t k = 0; k < d; ++k) {
    along += q[k] * v[k];
    together += p[k] * q[k];
  }
  // Steps are shorter than half a circle, so `together` is not near zero.
  const double factor = along / together;
  for (std::size_t k = 0; k < d; ++k)
    v[k] -= factor * (p[k] + q[k]);
}

}  // namespace orbicube::sphere_optimizer
