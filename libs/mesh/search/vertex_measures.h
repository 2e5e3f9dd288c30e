// What a surface has at its vertices: normals and areas.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// Computes unit normals of the vertices of a surface: of its triangles' normals, each weighted by the angle at the
// vertex (Thuermer and Wuethrich, Computing vertex normals from polygonal facets, 1998), which does not depend on how
// faces are cut. (0, 0, 1) where they cancel and for vertices in no triangle. Throws Error "cancelled". O(n).
Array<Vector3> vertex_normals(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                              const base::Host& host);

// Computes a third of the area of its triangles for each vertex: the weights that a fit of a surface has by default, so
// that each piece of the surface counts by its own size, not by how many vertices it has. Throws Error "index-range",
// "cancelled". O(n).
Array<double> vertex_areas(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const base::Host& host);

}  // namespace orbicube::mesh
