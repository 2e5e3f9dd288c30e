// Texture coordinates in float32, in which triangles keep their orientation.
#pragma once

#include <cstddef>
#include <span>

#include "mesh/mesh.h"

namespace orbicube::cli {

// Moves vertices of triangles that rounding made flat or mirrored, by a few units in the last place, to where fewer
// are: inner ones anywhere, others along the horizontal or vertical side that they are on. Triangles are
// counter-clockwise where v, which goes down, is turned up. Returns the number of triangles that remain so, by exact
// signs.
std::size_t mend_coordinates(std::span<const mesh::Triangle> triangles, std::span<float> coordinates);

}  // namespace orbicube::cli
