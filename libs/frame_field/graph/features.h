// Sharp edges of the boundary as constraints: the frames beside one follow it with an axis.
#pragma once

#include "frame_field/graph/constraints.h"

namespace orbicube::frame_field {

// An edge of the boundary is a feature when the normals on its two sides differ by more than `angle` (radians). The
// tetrahedra with a boundary face at a feature get a whole frame, from normal and edge; the others around it an axis
// along the edge. What is given already stays; of several features of one tetrahedron the first counts. O(n).
void follow_features(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                     double angle, const base::Host& host, Array<GivenFrame>& frames, Array<GivenAxis>& axes);

}  // namespace orbicube::frame_field
