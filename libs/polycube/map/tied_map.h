// Positions of a labeled surface on a polycube, whose patches are flat by construction: the coordinate of a patch along
// its own axis is one variable, which all its vertices share.
//
// Vertices inside a patch have two variables of their own, those along an arc one, corners none. Since three patches at
// most meet at a vertex and neighbors have different axes (patches.h), no vertex lies on two patches of one axis.
#pragma once

#include <array>
#include <span>

#include "polycube/labels/patches.h"
#include "untangle/triangles/planar_triangles.h"

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

// Returns the triangles of a tied map as functions of its variables: those of the corners along the two axes of the
// patch, u (turned so that positive determinants are positive triangles) and v. Weights are areas, relative to the
// whole.
untangle::PlanarTriangles triangles_of(const TiedMap& map, const base::Host& host);

}  // namespace orbicube::polycube
