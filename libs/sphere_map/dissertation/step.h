// The dissertation's Algorithm 2 (section 3.1.4): one vertex of a spherical triangulation is moved along the great
// circle through its energy's negative gradient, by an Armijo-type back-tracking search.
//
// As printed, with four mends, each where the printed search fails:
//   1. A candidate is taken only if every triangle of the ring stays positive. The printed test looks at the energy
//      alone, which stays finite when a triangle collapses or flips, and Case 1's first point, on the ring, is
//      outside of the kernel of a ring that is not star-shaped from there.
//   2. No move raises the quasi-conformal distortion of a triangle beyond a bound that is far from what good maps have.
//   E is lowest
//      where long protrusions have collapsed; the kernels of the vertices that are split in there are then empty (the
//      cow and the bunny fail).
//   3. The search ends after 60 halvings. "While true" never ends where rounding, or the kink of d^-2 where a triangle
//      becomes obtuse, lets no candidate pass.
//   4. A candidate must lower the energy. For Case 1 the printed bound is above the energy itself on long arcs, since
//      the radial part of d_k . grad E is then positive.
// Eq. 3.3 is read with E_D(T) as a density: as printed it carries an Area(t) too many, and vanishes under refinement.
#pragma once

#include <span>

#include "sphere_map/optimization/vertex_step.h"

namespace orbicube::sphere_map::dissertation {

// E = angle_weight E_D + area_weight E_A, eq. 3.5, and nothing else.
struct PrintedEnergy {
  double angle_weight, area_weight;
  double area_scale;           // surface area times this is 4 pi in all
  double max_quasi_conformal;  // the bound of mend 2, on (K + 1/K) / 2
};

double triangle_energy(const PrintedEnergy& energy, const TriangleShape& shape, const Vector3& p, const Vector3& q,
                       const Vector3& r);

double star_energy(const PrintedEnergy& energy, std::span<const StarTriangle> star, const Vector3& position,
                   std::span<const Vector3> directions);

// Eq. 3.6: the violation rho of the first-order condition (eq. 3.7) times the mean distance to the ring, which section
// 3.1.5 takes for the distance to the kernel's boundary.
double priority(const PrintedEnergy& energy, Index vertex, std::span<const StarTriangle> star,
                std::span<const Vector3> directions);

// Algorithm 2. Moves directions[vertex] if that lowers the energy of its star; returns by how much.
double great_circle_search(const PrintedEnergy& energy, Index vertex, std::span<const StarTriangle> star,
                           std::span<Vector3> directions);

}  // namespace orbicube::sphere_map::dissertation
