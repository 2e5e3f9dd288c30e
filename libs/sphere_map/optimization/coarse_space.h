// A coarse space for the systems of a StarMatrix, which brings what spreads over many vertices, as the rotation of a
// whole protrusion, in one step: each cluster of neighbors moves as a similarity of its tangent plane, so that a small
// one can move far, turn and grow without distortion. Conjugate gradients then take a tenth of the steps.
#pragma once

#include <memory>

#include "linear/direct/direct_factor.h"
#include "sphere_map/optimization/star_matrix.h"

namespace orbicube::sphere_map {

class CoarseSpace {
 public:
  // Clusters the vertices of the matrix by its neighbors.
  CoarseSpace(const StarMatrix& matrix, const base::Host& host, const base::ThreadPool& pool);

  // Sets the movements of clusters at these points, and factors the matrix in them (Galerkin), its diagonal raised
  // until it is positive. Does not correct anything where that fails.
  void set(const StarMatrix& matrix, std::span<const Vector3> points);

  // Adds to z the solution in the space for the residual.
  void correct(std::span<const Vector2d> residual, std::span<Vector2d> z);

 private:
  using Modes = Eigen::Matrix<double, 2, 4>;  // two translations, rotation, scaling, in the tangent basis of a vertex

  std::span<const Index> cluster(std::size_t c) const {
    return {members_.data() + begin_[c], begin_[c + 1] - begin_[c]};
  }
  void set_modes(std::span<const Index> cluster, std::span<const Vector3> points);
  // A block of the matrix: the other cluster, and the entries.
  using Blocks = base::Array<std::pair<std::size_t, Eigen::Matrix4d>>;
  void add_rows(std::size_t c, const StarMatrix& matrix, Blocks& blocks, linear::Triplets& entries) const;
  void factor(linear::SparseMatrix& coarse);

  const base::Host& host_;
  const base::ThreadPool& pool_;
  std::size_t count_;  // of clusters
  base::Array<Index> cluster_of_;
  base::Array<Index> members_;  // vertices by cluster
  base::Array<std::size_t> begin_;
  base::Array<Modes> modes_;
  std::unique_ptr<linear::DirectFactor> factor_;
  Eigen::VectorXd solution_;
  bool analyzed_ = false, usable_ = false;
};

}  // namespace orbicube::sphere_map
