// Tangents of a surface with texture coordinates, as normal maps need them (glTF 2.0 specification, 3.7.2.1).
#pragma once

#include <span>

#include "base/array.h"
#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::gltf {

// One tangent a vertex, four floats each: a unit vector orthogonal to the normal, in the direction in which the first
// texture coordinate grows on the surface, and 1, or -1 where the texture is mirrored (v goes down, as glTF has it, and
// the cross product of normal and tangent, times that number, goes up). The sum over the triangles of a vertex,
// weighted by their areas; any direction across the normal where that sum is zero. `positions` and `normals` have three
// floats a vertex, `coordinates` two. O(n). Throws Error "cancelled".
base::Array<float> smooth_tangents(std::span<const float> positions, std::span<const float> normals,
                                   std::span<const float> coordinates, std::span<const mesh::Triangle> triangles,
                                   const base::Host& host);

}  // namespace orbicube::gltf
