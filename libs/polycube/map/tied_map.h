// Positions of a labeled surface on a polycube, whose patches are flat by construction: the coordinate of a patch along
// its own axis is one variable, which all its vertices share.
//
// Vertices inside a patch have two variables of their own, those along an arc one, corners none. Since three patches at
// most meet at a vertex and neighbors have different axes (patches.h), no vertex lies on two patches of one axis.
#pragma once

#include <array>
#include <span>

#include "polycube/labels/patches.h"

namespace orbicube::polycube {

struct TiedMap {
  // Keeps references to both. All variables are 0.
  TiedMap(const Surface& surface, const Patches& patches, const base::Host& host);

  double coordinate(Index vertex, int axis) const { return value[variable[vertex][static_cast<std::size_t>(axis)]]; }
  Vector3 position(Index vertex) const { return {coordinate(vertex, 0), coordinate(vertex, 1), coordinate(vertex, 2)}; }
  AxisLabel label(Index triangle) const { return patches->labels[patches->patch[triangle]]; }

  const Surface* surface;
  const Patches* patches;
  Array<std::array<Index, 3>> variable;  // of each vertex and axis; those of patches come first, by their numbers
  Array<double> value;                   // of each variable
};

// The triangles of a tied map as functions of its variables: for each triangle the gradients of the three hat functions
// in its own plane, and the variables of its corners along the two axes of its patch, (u, v) of corner 0, 1, 2.
struct TiedTriangles {
  TiedTriangles(const TiedMap& map, const base::Host& host);

  // Rows: u (turned so that positive determinants are positive triangles) and v of the polycube; columns: the plane of
  // the triangle in space.
  Eigen::Matrix2d jacobian(std::span<const double> value, std::size_t triangle) const {
    Eigen::Matrix2d j = Eigen::Matrix2d::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      j.row(0) += sign[triangle] * value[variables[triangle][2 * k]] * gradients[triangle][k].transpose();
      j.row(1) += value[variables[triangle][2 * k + 1]] * gradients[triangle][k].transpose();
    }
    return j;
  }

  Array<std::array<Eigen::Vector2d, 3>> gradients;
  Array<std::array<Index, 6>> variables;
  Array<double> sign;
  Array<double> weight;  // areas, relative to the whole
};

}  // namespace orbicube::polycube
