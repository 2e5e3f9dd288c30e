// The caller's arrays as the C++ side takes them: doubles and indices have the layout of its vectors and triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>

#include "capi/src/entry.h"
#include "mesh/mesh.h"
#include "orbicube/mesh.h"

namespace orbicube::capi {

// Throws if `numbers` is NULL or they are too many; `what` names them.
template <class Element, class Number>
std::span<const Element> view(const Number* numbers, std::size_t count, const char* what) {
  static_assert(sizeof(Element) % sizeof(Number) == 0 && alignof(Element) == alignof(Number));
  if (count > 0 && numbers == nullptr) throw base::Error("invalid-argument", std::string(what) + " is NULL");
  if (count > PTRDIFF_MAX / sizeof(Element)) throw base::Error("invalid-argument", std::string(what) + ": too many");
  return {reinterpret_cast<const Element*>(numbers), count};
}

// Copies a contiguous array to the caller's, unless that is NULL.
template <class Elements, class Number>
void copy(const Elements& from, Number* to) {
  if (to != nullptr && !from.empty()) std::memcpy(to, from.data(), from.size() * sizeof from[0]);
}

struct SurfaceView {
  std::span<const mesh::Vector3> positions;
  std::span<const mesh::Triangle> triangles;

  explicit SurfaceView(const obc_surface* from) {
    require(from != nullptr, "surface is NULL");
    positions = view<mesh::Vector3>(from->positions, from->vertex_count, "surface->positions");
    triangles = view<mesh::Triangle>(from->triangles, from->triangle_count, "surface->triangles");
  }
};

}  // namespace orbicube::capi
