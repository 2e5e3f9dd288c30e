// Whether a surface looks like that of a machined part: faces that meet at sharp edges. Surfaces must be closed and
// oriented.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::hexmesh {

// Edges that bend by 40 degrees or more are at least half as long together as those that bend by 10 to 40 degrees. Of
// scans, which bend everywhere, they are a few hundredths to a third as long.
// O(n log n). Throws what mesh::Connectivity does.
bool is_machined(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles,
                 const base::Host& host);

// Edges that bend by at least `angle` degrees are lines: few of them end, and few branch. Those of scans and sculpted
// shapes do both, being parts of what is round. O(n log n). Throws what mesh::Connectivity does.
bool has_sharp_lines(std::span<const mesh::Vector3> positions, std::span<const mesh::Triangle> triangles, double angle,
                     const base::Host& host);

}  // namespace orbicube::hexmesh
