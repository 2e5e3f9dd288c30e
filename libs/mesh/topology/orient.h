// Consistent orientation: all triangles of a surface turned the same way, and outward where it is closed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/host.h"
#include "mesh/mesh.h"
#include "mesh/topology/edge_table.h"

namespace orbicube::mesh {

// 1 for each triangle that has to be reversed so that every edge of two triangles is passed once in each direction,
// 0 for the others; the lowest triangle of each part stays. Nothing when the surface is not orientable. O(n).
std::optional<Array<std::uint8_t>> orientation_signs(std::span<const Triangle> triangles, const EdgeTable& edges,
                                                     const base::Host& host);

struct OrientReport {
  std::size_t reversed_triangles = 0;  // to agree with their neighbors
  bool inward_oriented = false;        // then all of them again

  // What was done, in sentences for users; none where nothing was.
  std::vector<std::string> notes() const;
};

// Turns triangles so that they agree with their neighbors, the fewer of each part, and then all of them when the
// surface is closed and has negative volume; an inner wall that looks into its cavity stays as it is. Changes nothing
// that is consistent and outward already. Indices must be below positions.size(). Throws Error "non-orientable",
// "cancelled". O(n).
OrientReport orient(std::span<const Vector3> positions, std::span<Triangle> triangles, const base::Host& host);

}  // namespace orbicube::mesh
