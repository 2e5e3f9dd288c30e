// Surfaces at a size and place where no square overflows, vanishes or cancels.
#pragma once

#include <memory_resource>
#include <span>

#include "mesh/mesh.h"

namespace orbicube::sphere_map {

using base::Array;
using mesh::Vector3;

// The positions (finite) moved so that their bounding box is round the origin, and scaled so that its diagonal is 1.
// When all are at one point, all are zero.
Array<Vector3> normalised(std::span<const Vector3> positions, std::pmr::memory_resource* memory);

}  // namespace orbicube::sphere_map
