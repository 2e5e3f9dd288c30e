// Where the triangles of a mesh lie on a surface whose materials and texture coordinates they are to have, by position.
#pragma once

#include <span>

#include "base/host.h"
#include "gltf/writing/write.h"
#include "mesh/mesh.h"

namespace orbicube::gltf {

// Finds the nearest place on the surface for `positions`, one for each vertex of `triangles`, and for `middles`, one
// for each triangle. The surface has a triangle, and squares of all coordinates are in the range of double. O(log n) a
// triangle on average. Throws Error "cancelled".
base::Array<KeptTriangle> nearest_kept_triangles(const mesh::Mesh& surface, std::span<const mesh::Vector3> positions,
                                                 std::span<const mesh::Triangle> triangles,
                                                 std::span<const mesh::Vector3> middles, const base::Host& host);

}  // namespace orbicube::gltf
