// The regularized determinant of the foldover-free energy of triangles and tetrahedra (Garanzha, Kaporin, Kudryavtseva,
// Protais, Ray and Sokolov 2021, "Foldover-free maps in 50 lines of code"):
//
//   chi(D, eps) = (D + sqrt(eps^2 + D^2)) / 2,  D = det J,
//
// which is positive for any D; with eps = 0 and D > 0 it is D, and the energy a barrier. The energy is in
// tetrahedra/foldover_energy.h and triangles/planar_triangles.h, that of positive triangles in triangles/barrier.h.
#pragma once

#include <cmath>

namespace orbicube::untangle {

struct Chi {
  double value;
  double root;  // sqrt(eps^2 + D^2): the derivative of chi by D is chi / root
};

inline Chi chi_of(double determinant, double eps) {
  if (eps <= 0) return {determinant, determinant};
  const double root = std::sqrt(eps * eps + determinant * determinant);
  // Without cancellation on the negative side.
  return {determinant >= 0 ? 0.5 * (determinant + root) : 0.5 * eps * eps / (root - determinant), root};
}

}  // namespace orbicube::untangle
