// Where float32 holds a shape: the node of a glTF file moves and scales what its accessors hold.
#pragma once

#include <span>

#include "mesh/mesh.h"

namespace orbicube::gltf {

// world = translation + scale * stored.
struct FloatFrame {
  mesh::Vector3 translation = mesh::Vector3::Zero();
  double scale = 1;

  mesh::Vector3 stored(const mesh::Vector3& world) const { return (world - translation) / scale; }
};

// What to divide coordinates by, of at most this size, so that they and what is computed with them stay within the
// normal numbers of float32: 1 for sizes from 1e-30 to 1e30, else a power of two. Throws Error "unsupported" where that
// power would be none itself.
double float_scale(double size);

// Of a shape between two corners: moved where float32 would lose more than a millionth of its size far from the origin,
// and scaled by float_scale. Stored coordinates are exact multiples of the world's where it is not moved.
FloatFrame float_frame(const mesh::Vector3& low, const mesh::Vector3& high);

// Returns the stored coordinates of positions, three each, rounded to float32.
base::Array<float> stored_positions(std::span<const mesh::Vector3> positions, const FloatFrame& frame,
                                    std::pmr::memory_resource* memory);

}  // namespace orbicube::gltf
