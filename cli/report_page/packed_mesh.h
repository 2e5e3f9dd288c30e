// A map as the page's script reads it (mesh_data.js): quantised, connections as a walk over the triangles, in base64.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "report_page.h"

namespace orbicube::cli {

// Levels of a triangle's distortion: one byte each, logarithmic, so that every colour scale can be made from them.
inline constexpr double dilatation_levels_per_octave = 32;  // level 0 is dilatation 1
inline constexpr double area_levels_per_octave = 10;        // level 128 is area ratio 1
inline constexpr std::size_t area_level_of_one = 128;
inline constexpr std::size_t no_dilatation_level = 255;  // of triangles without area on the shape
inline constexpr std::size_t no_area_level = 0;

struct PackedMesh {
  std::size_t vertices = 0;   // those of a triangle; the others are left out
  std::size_t triangles = 0;  // in the order of the walk
  mesh::Vector3 low;          // a vertex is at low + step * its three numbers
  double step = 0;
  std::string positions;    // three 16-bit numbers a vertex, low byte first, as all here
  std::string directions;   // two 24-bit numbers a vertex: octahedral coordinates (Cigolle et al. 2014)
  std::string connections;  // numbers of 7 bits a byte, see walk() in packed_mesh.cpp
  std::string dilatation;   // one level a triangle
  std::string area_ratio;
  std::array<double, 256> dilatation_share{};  // part of the shape's area at each level
  std::array<double, 256> area_ratio_share{};
};

// The directions are turned by the rotation that brings them nearest to where the vertices are on the shape, so that
// both face the same way. O(n). Throws Error invalid-argument as report_page does.
PackedMesh pack(const PageResult& result);

}  // namespace orbicube::cli
