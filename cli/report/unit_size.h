// Shapes of extreme size are mapped and meshed at a size near 1, where products of lengths neither overflow nor vanish.
#pragma once

#include <cmath>
#include <cstdlib>
#include <string>

#include "files/surface_file.h"
#include "mesh/search/unit_scale.h"
#include "session/session.h"

namespace orbicube::cli {

// Throws Failure for a shape that is compared with others in its own unit, and too small or large for products of
// lengths.
inline void require_ordinary_size(const mesh::Mesh& m, const std::string& path) {
  constexpr int ordinary = 100;
  if (std::abs(mesh::unit_scale_exponent(m.positions, m.triangles)) > ordinary)
    throw Failure(Exit::wrong_input, path, "unsupported",
                  "its size is below 1e-30 or above 1e30, where this cannot be computed; scale it first");
}

// What is computed at another scale, in the unit of the input; null beyond the range of double.
inline Json unscaled(double value, int exponent) {
  const double result = std::ldexp(value, exponent);
  return std::isfinite(result) && (result != 0 || value == 0) ? Json(result) : Json();
}

}  // namespace orbicube::cli
