// Surfaces at a size and place where no square overflows, vanishes or cancels.
#pragma once

#include <memory_resource>
#include <span>

#include "mesh/mesh.h"

namespace orbicube::mesh {

// Center and size of the bounding box of the triangles' vertices; vertices in no triangle do not count.
struct Placing {
  Vector3 centre = Vector3::Zero();
  double half_size = 0;  // half of the longest side of the box
  double diagonal = 1;   // of the box, over half_size

  Vector3 operator()(const Vector3& p) const { return (p - centre) / half_size / diagonal; }
  // From the center, of length 1; z where there is none.
  Vector3 direction(const Vector3& p) const;
};
Placing placing_of(std::span<const Vector3> positions, std::span<const Triangle> triangles);

// The positions (finite) moved so that the bounding box of the triangles is round the origin, and scaled so that its
// diagonal is 1. Vertices in no triangle are zero, all when all triangles are at one point. Scaling the positions by a
// power of two changes no bit.
Array<Vector3> normalized(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                          std::pmr::memory_resource* memory);

}  // namespace orbicube::mesh
