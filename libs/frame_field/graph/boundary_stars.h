// Frames of tetrahedra that meet the boundary in a vertex or an edge alone, as constraints: where they follow the
// boundary too, a singular curve comes no nearer to it than the next vertex, unless it ends there. In coarse tetrahedra
// curves beside the boundary would else go along it, where no hexahedral mesh has them.
#pragma once

#include "frame_field/graph/constraints.h"

namespace orbicube::frame_field {

// At a vertex of the boundary where all normals are about one they get an axis along that, and where there are two or
// three about perpendicular to each other, as at sharp edges and corners, a whole frame, also where they have a face on
// the boundary; elsewhere nothing. What is given already stays. O(n).
void follow_boundary_stars(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                           const base::Host& host, Array<GivenFrame>& frames, Array<GivenAxis>& axes);

}  // namespace orbicube::frame_field
