// What every function that takes a surface from outside requires of it first.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// Throws Error "invalid-argument" for a triangle with an index that is out of range, a position that is not finite, or
// more vertices than indices can count; "cancelled". O(n).
void require_valid_surface(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const base::Host& host);

}  // namespace orbicube::mesh
