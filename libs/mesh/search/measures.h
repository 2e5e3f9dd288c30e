// Bounding box, area and volume, computed relative to the box, so that surfaces that are far from the origin, huge or
// tiny lose nothing.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

struct Measures {
  Vector3 low = Vector3::Zero(), high = Vector3::Zero();  // bounding box of the triangles
  double area = 0;
  double volume = 0;  // enclosed by a closed oriented surface; negative when it is inward-oriented
};

// 1 for vertices of triangles, 0 for the others, which no figure of a surface counts. Corners that are no vertex are
// passed over.
Array<std::uint8_t> used_vertices(std::size_t vertex_count, std::span<const Triangle> triangles,
                                  std::pmr::memory_resource* memory);

// O(n). Area and volume beyond the range of double are infinite, or the smallest number of their sign. Positions must
// be finite.
Measures measures(std::span<const Vector3> positions, std::span<const Triangle> triangles, const base::Host& host);

}  // namespace orbicube::mesh
