// The caller's arrays of a surface as the C++ side takes them: doubles and indices have the layout of its vectors and
// triangles.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "capi/src/entry.h"
#include "mesh/mesh.h"
#include "orbicube/mesh.h"

namespace orbicube::capi {

struct SurfaceView {
  std::span<const mesh::Vector3> positions;
  std::span<const mesh::Triangle> triangles;

  explicit SurfaceView(const obc_surface* from) {
    static_assert(sizeof(mesh::Vector3) == 3 * sizeof(double) && sizeof(mesh::Triangle) == 3 * sizeof(uint32_t));
    require(from != nullptr, "surface is NULL");
    require(from->positions != nullptr || from->vertex_count == 0, "surface->positions is NULL");
    require(from->triangles != nullptr || from->triangle_count == 0, "surface->triangles is NULL");
    require(std::max(from->vertex_count, from->triangle_count) <= PTRDIFF_MAX / sizeof(mesh::Vector3),
            "surface: too many vertices or triangles");
    positions = {reinterpret_cast<const mesh::Vector3*>(from->positions), from->vertex_count};
    triangles = {reinterpret_cast<const mesh::Triangle*>(from->triangles), from->triangle_count};
  }
};

}  // namespace orbicube::capi
