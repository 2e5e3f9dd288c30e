// Simple voxels: those that can enter or leave an object without a change of its topology (Bertrand and Malandain
// 1994), for objects connected through faces and backgrounds connected through faces, edges and corners.
#pragma once

#include <cstdint>

namespace orbicube::repair {

// Bit n is set if neighbor n is in the object, see Voxels::offset; bit 13, the voxel itself, does not count.
using Neighborhood = std::uint32_t;

// Whether the neighbors in the object that share a face with the voxel are there and connected through faces within the
// 18 neighbors that share a face or an edge, and the neighbors in the background are there and connected.
bool is_simple(Neighborhood object);

}  // namespace orbicube::repair
