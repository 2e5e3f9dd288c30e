// The result, made of TetGen's mesh and checked: inside distinguished from cavities, vertices and triangles numbered as
// in the surface, signs exact.
#pragma once

#include <span>

#include "base/host.h"
#include "tetrahedra/scaled_surface.h"
#include "tetrahedra/tetgen_call.h"
#include "tetrahedra/tetrahedra.h"

namespace orbicube::tetrahedra {

// Throws Error "no-valid-result" when the mesh is not one that fills the surface, "cancelled". O(n).
Solid assemble(std::span<const Vector3> positions, std::span<const Triangle> triangles, const ScaledSurface& surface,
               const TetgenMesh& made, bool keep_surface, const base::Host& host);

}  // namespace orbicube::tetrahedra
