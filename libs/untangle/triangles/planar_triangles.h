// Triangles that a map takes to the plane, and the foldover-free energy of the map (Garanzha, Kaporin, Kudryavtseva,
// Protais, Ray and Sokolov 2021, "Foldover-free maps in 50 lines of code"):
//
//   sum over triangles of weight / 2 [|J|^2 + lambda (1 + D^2)] / chi,  D = det J,
//   chi(D, eps) = (D + sqrt(eps^2 + D^2)) / 2.
//
// With eps = 0 chi is D: a barrier, infinite unless every triangle is positive. With weights that are areas and add up
// to 1 it is then the mean over the surface of angle + lambda area distortion. With t = chi' / chi, a = vec J and
// c = vec cof J the block
//   (1 / chi) [I - t (c a' + a c') + (t^2 |a|^2 + lambda ((1 - D t)^2 + t^2)) c c']
// is the PSD projection of a triangle's Hessian.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "untangle/types.h"

namespace orbicube::untangle {

using Eigen::Vector2d;

// Of the energy of a triangle of weight 1, by the entries of J, row by row.
struct TriangleDerivatives {
  Eigen::Vector4d gradient;
  Eigen::Matrix4d block;
};
TriangleDerivatives differentiate(const Eigen::Matrix2d& jacobian, double eps, double lambda);

// Any coordinate of a triangle in the plane is plus or minus one of a list, which several may share.
struct PlanarTriangles {
  explicit PlanarTriangles(std::pmr::memory_resource* memory)
      : variables(memory), signs(memory), hats(memory), weights(memory) {}

  std::size_t size() const { return weights.size(); }
  void clear();
  // Corners in space, in the scale of the plane; coordinates in the plane, counter-clockwise. A triangle counts as if
  // it had at least the minimum area: what is lost in the mean over the surface would become needles otherwise.
  void add(const std::array<Vector3, 3>& space, const std::array<Index, 6>& coordinates,
           const std::array<double, 6>& sign, double whole_area, double min_area);
  Eigen::Matrix2d jacobian(std::span<const double> values, std::size_t triangle) const {
    Eigen::Matrix2d j = Eigen::Matrix2d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector2d& hat = hats[triangle][k];
      j.row(0) += signs[triangle][2 * k] * values[variables[triangle][2 * k]] * hat.transpose();
      j.row(1) += signs[triangle][2 * k + 1] * values[variables[triangle][2 * k + 1]] * hat.transpose();
    }
    return j;
  }
  // With eps 0 infinite unless every triangle is positive.
  double energy(std::span<const double> values, double lambda, double eps = 0) const;

  // Coordinate k of corner i is signs[2 i + k] * values[variables[2 i + k]].
  Array<std::array<Index, 6>> variables;
  Array<std::array<double, 6>> signs;
  Array<std::array<Vector2d, 3>> hats;  // gradients of the corners' hat functions, in the plane of the triangle
  Array<double> weights;                // area in space over the whole area, or the minimum
};

}  // namespace orbicube::untangle
