// Smooth normals of a triangle mesh.
#pragma once

#include <span>

#include "base/array.h"
#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::gltf {

// One unit vector a vertex (three floats each): the sum of its triangles' normals weighted by their areas, normalized.
// (0, 0, 1) where that sum is zero or the vertex is in no triangle. `positions` has three floats a vertex. O(n).
base::Array<float> smooth_normals(std::span<const float> positions, std::span<const mesh::Triangle> triangles,
                                  const base::Host& host);

}  // namespace orbicube::gltf
