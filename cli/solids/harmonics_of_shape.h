// A shape as values on the sphere of its map, and back.
#pragma once

#include <span>

#include "base/host.h"
#include "harmonics/functions/coefficients.h"
#include "mesh/mesh.h"

namespace orbicube::cli {

// Positions as values at the map's directions: three channels.
std::span<const double> numbers(const base::Array<mesh::Vector3>& positions);

// The surface that the coefficients make at the directions of the map, with the triangles of the map.
mesh::Mesh surface_of(const harmonics::Coefficients& coefficients, const mesh::Mesh& map, const base::Host& host);

// e(M, M^) of the dissertation's section 3.3.2 for a shape of area 4 pi: the mean distance between the vertices of
// both that are of triangles, the larger of the two ways. At any scale that double has.
double reconstruction_error(const mesh::Mesh& shape, const mesh::Mesh& made, const base::Host& host);

}  // namespace orbicube::cli
