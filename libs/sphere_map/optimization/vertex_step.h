// One optimization step of one vertex of a spherical triangulation, with its ring fixed.
//
// The dissertation's Algorithm 2 searches the great circle through the negative gradient. Here the great circle is that
// of Newton's direction: the 2 x 2 Riemannian Hessian P'HP - (g . p) I with its eigenvalues made positive. The search
// starts at most 0.7 of the way to where the first triangle of the ring would collapse (to first order), so that no
// search leaves the spherical kernel, and every accepted point is checked to be safely inside of it.
#pragma once

#include <span>

#include "base/array.h"
#include "sphere_map/optimization/distortion.h"

namespace orbicube::sphere_map {

using base::Array;

// A triangle (v, q, r) of the star of a vertex v.
struct StarTriangle {
  Index q, r;
  TriangleShape shape;  // p stands for v
};

struct StepResult {
  double energy = 0;    // of the star before the step
  double gain = 0;      // by how much it fell; 0 when the vertex stays
  double movement = 0;  // length of the step over the distance to the nearest ring vertex
};

// Scratch space of improve_vertex, kept between calls so that no call allocates once it has grown.
struct StepScratch {
  explicit StepScratch(std::pmr::memory_resource* memory) : heights(memory) {}
  struct Height {
    double now, by_first, by_second;  // determinant of a star triangle and its derivative along the tangent basis
  };
  Array<Height> heights;
};

// Energy of the star of a vertex at `position`.
double star_energy(const Energy& energy, std::span<const StarTriangle> star, const Vector3& position,
                   std::span<const Vector3> directions);

// Moves directions[vertex] if that lowers the energy of its star.
StepResult improve_vertex(const Energy& energy, Index vertex, std::span<const StarTriangle> star,
                          std::span<Vector3> directions, StepScratch& scratch);

}  // namespace orbicube::sphere_map
