// Where the triangles of a mesh lie on a shape whose materials and texture coordinates they are to have.
#pragma once

#include <span>

#include "base/host.h"
#include "gltf/writing/write.h"
#include "mesh/mesh.h"
#include "sphere_map/sampling/locator.h"

namespace orbicube::cli {

// `directions` are on the shape's own sphere, one for each vertex of `triangles`. O(1) a triangle on average. Throws
// Error "cancelled".
base::Array<gltf::KeptTriangle> kept_triangles(const sphere_map::Locator& shape,
                                               std::span<const mesh::Vector3> directions,
                                               std::span<const mesh::Triangle> triangles, const base::Host& host);

}  // namespace orbicube::cli
