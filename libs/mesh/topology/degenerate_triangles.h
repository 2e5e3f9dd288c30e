// Triangles that are taken as degenerate: their height is nothing beside their longest side, or beside the rounding of
// the coordinates. Their angles, and what a map does to them, are those of the rounding; figures leave them out, and no
// choice goes by them.
#pragma once

#include <span>

#include "mesh/mesh.h"

namespace orbicube::mesh {

// Height over the longest side. Larger: more slivers of the modeler count as degenerate; smaller: more of the noise of
// their heights enters figures, as its inverse. Thin triangles of real parts have 1e-5 and more.
inline constexpr double degenerate_height_ratio = 1e-6;

// Height over the largest coordinate, in units of its rounding: each of three corners is off by up to half a unit along
// each axis.
inline constexpr double degenerate_height_roundings = 4;

// The rounding unit of coordinates, relative to each: 2^-24 where every coordinate of a vertex of a triangle has the 24
// at most the digits of float32, as in STL and most PLY files, else 2^-53. O(n), less as a rule.
double rounding_unit(std::span<const Vector3> positions, std::span<const Triangle> triangles);
// Of all positions.
double rounding_unit(std::span<const Vector3> positions);

// Whether the triangle is degenerate, at any scale that double has. `rounding` as rounding_unit returns it; 0 compares
// with the longest side alone.
bool is_degenerate(const Vector3& p, const Vector3& q, const Vector3& r, double rounding);

// O(n).
std::size_t count_degenerate(std::span<const Vector3> positions, std::span<const Triangle> triangles);

}  // namespace orbicube::mesh
