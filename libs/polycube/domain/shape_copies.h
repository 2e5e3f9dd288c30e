// Shapes that are copies of others, moved, turned or scaled: their maps are those of the originals, triangle by
// triangle, so that they correspond by the identity. Two maps that are constructed one by one would not: a drawing that
// follows a map of the same shape ends at another local optimum.
#pragma once

#include <span>
#include <vector>

#include "base/host.h"
#include "polycube/domain/registration.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

// Returns for each shape the first one with the same triangles whose vertices a similarity takes to its own, within
// 1e-6 of the diagonal; itself where there is none before it.
std::vector<std::size_t> originals_of(std::span<const SurfaceSpan> shapes, const base::Host& host);

// Moves the vertices of a map to where they are on a surface with the same triangles as its own, whose vertices are at
// `positions`.
void put_onto(SurfaceMap& map, std::span<const Vector3> positions);

// Returns the map of a copy: `map` with `positions` of the vertices of the copy, which come first in a map's.
SurfaceMap map_of_copy(const SurfaceMap& map, std::span<const Vector3> positions, const base::Host& host);

}  // namespace orbicube::polycube
