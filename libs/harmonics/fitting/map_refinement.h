// Sphere maps that suit an expansion: vertices move on the sphere to where the surface of a given degree comes nearest
// to them.
//
// A fit of a closed surface leaves the directions free: the shape does not depend on them, its error does. Alternately
// the coefficients are fitted to the directions (fit.h), and each direction takes one damped Gauss-Newton step towards
// the point of the fitted surface that is nearest to its vertex, as parameters are corrected when curves are fitted to
// points (Hoschek 1988). A step is halved until all triangles around the vertex keep their orientation, so that a
// bijection stays one.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "harmonics/fitting/fit.h"

namespace orbicube::harmonics {

using Triangle = std::array<std::uint32_t, 3>;

struct RefinementOptions {
  FitOptions fit = {};
  std::uint32_t rounds = 10;  // maximum number of a fit and a step of all vertices
};

struct RefinementReport {
  std::uint32_t rounds = 0;    // that lowered the residual
  double residual_before = 0;  // root of the mean of |position - fit|^2, by weights
  double residual = 0;         // after; never more than before
};

// Changes `directions` (one a vertex, any length; unit vectors afterwards). Triangles that are positive or negative on
// the sphere, beyond rounding, stay so; vertices of others do not move. `weights` as in fit(). Same bits for any number
// of threads.
// Throws Error: as fit(), and index-range.
RefinementReport refine_map(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                            std::span<const double> weights, const RefinementOptions& options,
                            std::span<Vector3> directions, const base::Host& host);

}  // namespace orbicube::harmonics
