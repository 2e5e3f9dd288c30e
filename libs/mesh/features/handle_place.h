// Where a surface has a handle, for messages about surfaces of another genus.
#pragma once

#include <optional>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// Returns a vertex of a short closed curve that separates nothing, around a handle or through it; nothing for a surface
// without handles. The surface is closed, manifold and connected. A few spanning trees. Throws Error "cancelled".
std::optional<Index> handle_place(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                  const base::Host& host);

}  // namespace orbicube::mesh
