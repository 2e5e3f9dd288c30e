// Which vertices a surface needs when it is written with the attributes of its file: one for each vertex of the surface
// and each value that its attributes have there.
#pragma once

#include <vector>

#include "base/array.h"
#include "base/host.h"
#include "gltf/kept/attribute_blend.h"
#include "gltf/kept/kept.h"
#include "gltf/writing/write.h"

namespace orbicube::gltf {

// Vertices that primitives share.
struct VertexGroup {
  base::Array<BlendedVertex> vertices;      // of the primitives of the file, from 0
  base::Array<mesh::Index> surface_vertex;  // of the scene, for each
};

// A primitive to write.
struct PlacedPrimitive {
  const KeptPrimitive* from;
  std::size_t group;
  base::Array<mesh::Triangle> triangles;  // of vertices of the group
  bool turned = false;                    // the other way round than in the file
};

struct PlacedCorners {
  std::vector<VertexGroup> groups;
  std::vector<PlacedPrimitive> primitives;  // without those that have no triangles
};

// Throws Error "invalid-argument" when triangles are not those of what was kept, "cancelled". O(n).
PlacedCorners place_corners(const Scene& scene, const base::Host& host);

}  // namespace orbicube::gltf
