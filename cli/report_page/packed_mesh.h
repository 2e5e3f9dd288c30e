// A map as the page's script reads it (mesh_data.js): quantised, connections as a walk over the triangles, in base64.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "scenes/report_page.h"

namespace orbicube::cli {

// How a triangle's distortion becomes a level, one byte, from which every color scale can be made. With
// s = (level - zero) / span from -1 to 1, the level stands for the value 2^(octaves s |s|): finest near 1.
struct Levels {
  double zero;         // the level of value 1
  double span;         // levels from there to the end
  double octaves;      // of the last level
  std::uint8_t least;  // the levels in use
  std::uint8_t most;
  std::uint8_t none;  // the level of triangles without a value
};
inline constexpr Levels quasi_conformal_levels{0, 254, 8, 0, 254, 255};
inline constexpr Levels area_levels{128, 127, 12, 1, 255, 0};

struct PackedMesh {
  std::size_t vertices = 0;   // those of a triangle; the others are left out
  std::size_t triangles = 0;  // in the order of the walk
  mesh::Vector3 low;          // a vertex is at low + step * its three numbers
  double step = 0;
  std::string positions;    // three 16-bit numbers a vertex, low byte first, as all here
  std::string directions;   // two 24-bit numbers a vertex: octahedral coordinates (Cigolle et al. 2014)
  std::string polycube;     // instead of directions: as positions, from the polycube's own lowest corner, not turned
  std::string connections;  // numbers of 7 bits a byte, see walk() in packed_mesh.cpp
  std::string quasi_conformal;  // one level a triangle
  std::string area_ratio;
  std::string coefficients;  // of the harmonics, float32: of the sums in steps from `low`, at the unturned directions
  Eigen::Matrix3d facing;    // what turned the directions, or is to turn the polycube
  std::array<double, 256> quasi_conformal_share{};  // part of the shape's area at each level
  std::array<double, 256> area_ratio_share{};
};

// Directions are turned by the rotation that brings them nearest to where the vertices are on the shape, so that
// both face the same way. O(n). Throws Error invalid-argument as report_page does.
PackedMesh pack(const PageResult& result);

}  // namespace orbicube::cli
