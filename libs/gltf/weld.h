// Vertices that lie at the same place become one: files for rendering repeat a vertex for each normal or texture
// coordinate that meets there, so that what is one surface falls apart along its seams.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::gltf {

// Whether each edge is gone along as often one way as the other, as on a closed surface. O(triangles), save for
// vertices of very many. Indices must be below `vertex_count`.
bool is_closed(std::span<const mesh::Triangle> triangles, std::size_t vertex_count, const base::Host& host);

struct WeldReport {
  std::size_t vertices = 0;   // that were joined to an earlier one
  std::size_t triangles = 0;  // that had two corners at one place, and are gone
};

// Joins vertices at identical positions (-0 is 0) to the first of them; the others keep their order. O(n).
WeldReport weld(mesh::Mesh& surface, const base::Host& host);

}  // namespace orbicube::gltf
