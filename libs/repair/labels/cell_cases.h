// Surfaces inside a cell whose eight corners are voxel centers, for each of the 256 cases of corners in the object.
#pragma once

#include <array>
#include <cstdint>

namespace orbicube::repair {

// Corner c is at (c & 1, c >> 1 & 1, c >> 2). Edge 3 * c + axis runs from corner c, which has coordinate 0 along the
// axis; the other numbers below 24 are unused. Vertex `center_vertex` is a loop's centroid.
inline constexpr std::uint8_t center_vertex = 24;

struct CellPatch {
  std::array<std::uint8_t, 12>
      loop{};  // edges around the patch, the object on the left hand of the outward normal's walk
  std::uint8_t loop_size = 0;
  bool has_center = false;
  std::array<std::array<std::uint8_t, 3>, 12> triangles{};  // of edge numbers or center_vertex, outward-oriented
  std::uint8_t triangle_count = 0;
};

struct CellCase {
  std::array<CellPatch, 4> patches{};
  std::uint8_t patch_count = 0;
};

// Returns the case of the corners whose bits are set. On each face, corners of the object that are diagonal to each
// other are separated, so that the object is connected through faces of voxels and the background through corners. No
// triangle's edge other than those of the loops lies in a face of the cell, so that patches of adjacent cells share the
// edges of their loops only.
const CellCase& cell_case(std::uint8_t corners);

}  // namespace orbicube::repair
