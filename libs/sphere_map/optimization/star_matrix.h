// A symmetric matrix with a 2 x 2 block for each vertex of a level and for each edge, and the solution of systems with
// it.
#pragma once

#include <Eigen/Core>

#include "base/threads/thread_pool.h"
#include "sphere_map/hierarchy/level.h"

namespace orbicube::sphere_map {

using Eigen::Vector2d;

// The row of vertex i has an entry for each triangle k of its star: off_diagonal[k] joins it to the ring vertex that
// the triangle starts with. Every edge is stored from both ends, so that rows can be multiplied side by side. Single
// precision would not do: it loses the rotations of the sphere, which cost no energy.
class StarMatrix {
 public:
  StarMatrix(const Level& level, std::span<const Index> place, const base::Host& host);

  void set_zero(const base::ThreadPool& pool);

  std::size_t size() const { return diagonal.size(); }
  // Row of a vertex times x.
  Vector2d row_times(std::size_t i, std::span<const Vector2d> x) const {
    Vector2d sum = diagonal[i] * x[i];
    for (std::size_t k = begin_[i]; k < begin_[i + 1]; ++k)
      sum += off_diagonal[k] * x[column_[k]];
    return sum;
  }

  // Neighbors of a vertex, and the blocks that join it to them.
  std::span<const Index> columns(std::size_t i) const {
    return {column_.data() + begin_[i], begin_[i + 1] - begin_[i]};
  }
  std::span<const Eigen::Matrix2d> row(std::size_t i) const {
    return {off_diagonal.data() + begin_[i], begin_[i + 1] - begin_[i]};
  }

  base::Array<Eigen::Matrix2d> diagonal;
  base::Array<Eigen::Matrix2d> off_diagonal;

 private:
  std::span<const std::size_t> begin_;
  base::Array<Index> column_;
};

class CoarseSpace;

// A step of a trust region, measured in the norm of the preconditioner.
struct RegionStep {
  double length;  // of the step
  double gain;    // decrease of the quadratic model
  bool limited;   // by the radius
};

// Minimizes 0.5 x . matrix x - right_side . x within a radius by conjugate gradients (Steihaug 1983): ends when the
// residual has fallen to `tolerance` of its start, after max_steps, or where the path leaves the radius, which it
// follows to there, also along negative curvature. The preconditioner is the diagonal blocks with eigenvalues made
// positive, and the coarse space besides.
class ConjugateGradients {
 public:
  ConjugateGradients(std::size_t size, const base::Host& host, const base::ThreadPool& pool);

  // A negative radius is in units of the preconditioned right side.
  RegionStep solve(const StarMatrix& matrix, CoarseSpace& space, double radius, std::span<const Vector2d> right_side,
                   double tolerance, int max_steps, std::span<Vector2d> x);

 private:
  struct System;
  // Sum of term(i) over all vertices, after work(i) was done for each.
  template <class Term>
  double sum(const Term& term);

  const base::Host& host_;
  const base::ThreadPool& pool_;
  base::Array<Eigen::Matrix2d> inverse_;
  base::Array<Vector2d> residual_, preconditioned_, along_, product_;
  base::Array<double> partial_;  // sums of the pieces
};

}  // namespace orbicube::sphere_map
