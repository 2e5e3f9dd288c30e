// Vertices at identical positions become one, so that what was stored as loose triangles hangs together.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// For each vertex the lowest vertex at its very position (-0 is 0). O(n).
Array<Index> first_at_same_position(std::span<const Vector3> positions, const base::Host& host);

struct WeldReport {
  std::size_t vertices = 0;   // that were joined to an earlier one
  std::size_t triangles = 0;  // that had two corners at one position, and are gone
};

// Welds vertices at identical positions to the lowest of them; the others keep their order. Cells keep theirs, and
// triangles that had a repeated corner before stay. O(n).
WeldReport weld(Mesh& mesh, const base::Host& host);

}  // namespace orbicube::mesh
