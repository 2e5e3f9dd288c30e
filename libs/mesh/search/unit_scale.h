// Powers of two that bring surfaces to a size near 1, where no product of lengths overflows or vanishes. Scaling by
// them is exact, so that what is computed there is the same for a surface at any such scale.
#pragma once

#include <span>

#include "mesh/mesh.h"

namespace orbicube::mesh {

// The exponent e for which 2^e times the longest side of the triangles' bounding box is 1 to 2; 0 when the box is a
// point. Corners that are no vertex do not count. O(n).
int unit_scale_exponent(std::span<const Vector3> positions, std::span<const Triangle> triangles);

// Each coordinate times 2^exponent: exact but for results below 2^-1022, infinite for those that are out of range.
void scale_by_power(std::span<Vector3> positions, int exponent);

}  // namespace orbicube::mesh
