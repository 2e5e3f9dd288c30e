// The distortion of triangles that a map takes to planes, as a function of some of the coordinates there, and its
// minimum.
//
// The energy is the sum of weight (|J|^2 + lambda (D^2 + 1)) / (2 D), D = det J: the mean over the surface of angle +
// lambda area (distortion.h), when the weights are areas and add up to 1. While triangles are flipped, D below the
// fraction is chi(D, eps), and steps are Gauss-Newton's, as in untangling.h. There the coordinates are those of a whole
// polycube, tied by its faces; here any coordinate of a triangle is plus or minus one of a list, of which the first are
// free: so a part of a map can be unfolded around a corner.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "base/host.h"
#include "linear/sparse_system.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

using Eigen::Vector2d;

struct PlanarTriangles {
  explicit PlanarTriangles(std::pmr::memory_resource* memory)
      : variables(memory), signs(memory), hats(memory), weights(memory) {}

  std::size_t size() const { return weights.size(); }
  void clear();
  // Corners in space, at the scale of the polycube; coordinates in the plane, counter-clockwise. A triangle counts as
  // if it had at least the minimum area: what is lost in the mean over the surface would else become needles.
  void add(const std::array<Vector3, 3>& space, const std::array<Index, 6>& coordinates,
           const std::array<double, 6>& sign, double whole_area, double min_area);
  Eigen::Matrix2d jacobian(std::span<const double> value, std::size_t triangle) const;
  // Infinite unless every triangle is positive.
  double energy(std::span<const double> value, double area_weight) const;

  // Coordinate k of corner i is signs[2 i + k] * value[variables[2 i + k]].
  Array<std::array<Index, 6>> variables;
  Array<std::array<double, 6>> signs;
  Array<std::array<Vector2d, 3>> hats;  // gradients of the corners' hat functions, in the plane of the triangle
  Array<double> weights;                // area in space over the whole area, or the minimum
};

class DistortionMinimum {
 public:
  // The first `free` of the values are moved; neither is copied.
  DistortionMinimum(const PlanarTriangles& triangles, std::size_t free, double area_weight, std::span<double> value,
                    const base::Host& host);

  // Whether every triangle is positive at the end.
  bool untangle(int steps);
  // Lowers the energy of a positive map in at most the given number of steps, until one gains less than a part of it;
  // returns the energy.
  double minimise(int steps, double min_gain);

 private:
  double chi(double determinant, double* derivative) const;
  double energy_at(std::span<const double> value) const;
  double min_determinant(std::size_t* flipped) const;
  double longest_positive_step(std::span<const double> direction) const;
  void add_triangle(std::size_t t, const Eigen::Vector4d& g, const Eigen::Matrix4d& block);
  double assemble();
  Eigen::VectorXd descent_direction();
  double step();

  const PlanarTriangles& triangles_;
  std::size_t free_;
  double lambda_, eps_ = 0;
  std::span<double> value_;
  const base::Host& host_;
  Array<double> direction_, trial_;
  Array<std::array<std::uint32_t, 21>> places_;  // of the lower triangle of each triangle's block
  Array<std::uint32_t> diagonal_;
  linear::SparseSystem system_;
  Eigen::VectorXd gradient_;
};

}  // namespace orbicube::polycube
