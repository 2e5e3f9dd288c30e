// The surface and the directions of the C interface of sphere_map as the C++ side takes them.
#pragma once

#include <cstdint>
#include <new>
#include <span>
#include <string>
#include <type_traits>

#include "capi/src/entry.h"
#include "mesh/mesh.h"
#include "orbicube/sphere_map.h"

namespace orbicube::capi {

// Doubles and indices have the layout of vectors and triangles. No element counts more than memory can hold.
template <class Element, class Number>
auto view(Number* numbers, std::size_t count, const char* missing) {
  using Pointer = std::conditional_t<std::is_const_v<Number>, const Element, Element>;
  static_assert(sizeof(Element) % sizeof(Number) == 0 && alignof(Element) == alignof(Number));
  require(numbers != nullptr || count == 0, missing);
  require(count <= PTRDIFF_MAX / sizeof(Element), "a count is too large");
  return std::span<Pointer>(reinterpret_cast<Pointer*>(numbers), count);
}

struct Surface {
  std::span<const mesh::Vector3> positions;
  std::span<const mesh::Triangle> triangles;

  explicit Surface(const obc_surface* s) {
    require(s != nullptr, "surface is NULL");
    positions = view<mesh::Vector3>(s->positions, s->vertex_count, "surface->positions is NULL");
    triangles = view<mesh::Triangle>(s->triangles, s->triangle_count, "surface->triangles is NULL");
  }

  std::span<const mesh::Vector3> directions(const double* d) const {
    return view<mesh::Vector3>(d, positions.size(), "directions is NULL");
  }
};

// A mesh handle of the library mesh with these positions and triangles.
inline void hand_out(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                     const obc_host* host, obc_mesh** out) {
  obc_mesh_cells cells;
  obc_mesh_cells_init(&cells, sizeof cells);
  cells.positions = positions.empty() ? nullptr : positions.data()->data();
  cells.vertex_count = positions.size();
  cells.triangles = triangles.empty() ? nullptr : triangles.data()->data();
  cells.triangle_count = triangles.size();
  obc_error error;
  if (const obc_status status = obc_mesh_create(&cells, host, out, &error); status == OBC_OUT_OF_MEMORY) {
    throw std::bad_alloc();
  } else if (status == OBC_CANCELLED) {
    throw base::Error("cancelled", error.message);
  } else if (status == OBC_INVALID_ARGUMENT) {
    // What the caller gave is finite, and sums or products of it are not.
    throw base::Error("invalid-argument", error.message + std::string("; the given numbers are too large"));
  } else if (status != OBC_OK) {
    throw base::Error("internal", error.message);
  }
}

}  // namespace orbicube::capi
