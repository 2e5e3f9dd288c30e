// The angle at which the dissertation's Algorithm 2, as printed, begins its search on the great circle through p along
// its energy's negative gradient.
#pragma once

#include <algorithm>
#include <cmath>

#include "sphere_optimizer/spheres.h"

namespace orbicube::sphere_optimizer {

// G is the whole gradient at the unit vector p. Case 1 (G.p <= 0) ends the arc at -G / |G|; case 2 at the mirror image
// p - 2 (G.p) G / |G|^2, which is next to p where G.p is small and positive, and -p where G is along p.
template <class Dimension>
double printed_angle(Dimension d, const double* p, const double* whole_gradient) {
  const double along = block_dot(d, whole_gradient, p);
  const double size = std::sqrt(block_dot(d, whole_gradient, whole_gradient));
  return along <= 0 ? std::acos(std::min(1.0, -along / size)) : 2 * std::asin(std::min(1.0, along / size));
}

}  // namespace orbicube::sphere_optimizer
