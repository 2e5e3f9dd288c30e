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

// Scales the mesh by 2^exponent, which is returned, to a size of 1 to 2; 0 where the exponent would be `ordinary` at
// most (20: sizes of 1e-6 to 1e6): it stays as it is. The tetrahedra count or, without any, the triangles.
int bring_to_unit_size(Mesh& m, int ordinary = 20);

}  // namespace orbicube::mesh
