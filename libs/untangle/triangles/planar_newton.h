// Newton's method on the foldover-free energy of triangles in the plane (planar_triangles.h): until every triangle is
// positive, and to less distortion. Directions come from a sparse factor, lengths from halving.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "linear/sparse_system.h"
#include "untangle/triangles/planar_triangles.h"

namespace orbicube::untangle {

struct PlanarNewtonOptions {
  const char* phase = "untangle";  // of progress
  double shift = 1e-12;            // added to the diagonal of the Hessian, beside 1e-9 of each entry
  int max_trials = 30;             // of a line search
  int max_doublings = 3;           // of a whole step that is accepted while triangles are flipped
  // Whether the Hessian of a triangle is B' H first, then times B, rather than B' (H B): decides the last bits.
  bool left_product_first = true;
};

// How eps goes to 0.
struct PlanarSchedule {
  int max_steps = 150;     // of Newton's method, until every triangle is positive
  double area_weight = 1;  // lambda: weight of changes of area relative to those of angles
  double first_eps = 0;    // 0: a fifth of the worst determinant, 0.05 to 1
  int steps_an_eps = 6;    // maximum number of steps, until one gains less than 0.002 of the energy
  double fall = 0;         // from an eps to the next; 0: as in the paper, or 0.6
  int patience = 25;       // values of eps without fewer flipped triangles, after which it gives up
};

class PlanarNewton {
 public:
  // The first `free` of the variables move. Keeps a view of the triangles. About 400 bytes a triangle, and the factor.
  PlanarNewton(const PlanarTriangles& triangles, std::size_t free, const PlanarNewtonOptions& options,
               const base::Host& host);

  // Lets the energy fall until every triangle is positive, in floating point; returns whether it got there.
  bool untangle(std::span<double> values, const PlanarSchedule& schedule);
  // Lowers the energy of a positive map, and keeps it positive, in at most the given number of steps, or until one
  // gains less than `min_gain` of the energy.
  void polish(std::span<double> values, int steps, double min_gain, double area_weight);

  // Where triangles are nearly flat, which would stop a barrier, the eps with which untangle() ended goes on falling,
  // in at most the given number of steps, and the positive map of minimum energy on that way is kept.
  void settle(std::span<double> values, int max_steps, double area_weight);

  // Of all triangles; counts those that are flipped.
  double min_determinant(std::span<const double> values);
  std::size_t flipped() const { return flipped_; }  // when they were last counted
  std::size_t steps() const { return steps_; }      // taken, by both

 private:
  double longest_positive_step(std::span<const double> values) const;
  void add_triangle(std::size_t t, const TriangleDerivatives& of);
  double assemble(std::span<const double> values);
  void set_direction();
  double step(std::span<double> values);
  double next_eps(double least, double gain) const;

  const PlanarTriangles& triangles_;
  std::size_t free_;
  PlanarNewtonOptions options_;
  const base::Host& host_;
  linear::SparseSystem system_;
  Array<std::array<std::uint32_t, 21>> places_;  // of the lower triangle of each triangle's 6 x 6 block
  Array<std::uint32_t> diagonal_;
  Eigen::VectorXd gradient_, step_;
  Array<double> direction_, trial_, farther_;  // of all variables
  double lambda_ = 1, eps_ = 0, last_eps_ = 0;
  std::size_t flipped_ = 0, steps_ = 0;
};

}  // namespace orbicube::untangle
