// The pieces whose distortion a map is judged by: tetrahedra, each with the shape that it should have.
#pragma once

#include <array>
#include <span>

#include "untangle/tetrahedra/variables.h"

namespace orbicube::untangle {

// The Jacobian of the map on an element is the sum over its corners of position * gradient'.
struct Element {
  std::array<Index, 4> corner{};
  std::array<Vector3, 4> gradient{};
  double weight = 0;

  Eigen::Matrix3d jacobian(std::span<const Vector3> positions) const {
    Eigen::Matrix3d j = positions[corner[0]] * gradient[0].transpose();
    for (std::size_t k = 1; k < 4; ++k)
      j.noalias() += positions[corner[k]] * gradient[k].transpose();
    return j;
  }
};

// det [b - a, c - a, d - a]: six times the signed volume, in floating point.
inline double six_volumes(std::span<const Vector3> positions, const Tetrahedron& t) {
  const Vector3 &a = positions[t[0]], b = positions[t[1]] - a, c = positions[t[2]] - a, d = positions[t[3]] - a;
  return b.dot(c.cross(d));
}

// One element a tetrahedron. Those of `rest`, scaled by `scale`, are the target shapes, and weights are their volumes
// over the mean volume and a little, so that the smallest count too; without rest positions they are regular, all of
// one edge length `scale`. Throws Error "inverted-cell", "degenerate-cell" for a rest shape that is not positive,
// "cancelled".
Array<Element> elements_of(std::span<const Tetrahedron> tetrahedra, std::span<const Vector3> rest, double scale,
                           const base::Host& host);

}  // namespace orbicube::untangle
