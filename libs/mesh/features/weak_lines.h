// Lines along which a surface turns little, but clearly more than beside them.
#pragma once

#include "mesh/features/feature_lines.h"

namespace orbicube::mesh {

// Adds those of the candidates that turn by at least 3 degrees in the mean and by twice the largest turns beside them:
// of the curves of a CAD model these are the edges, and the others are seams of smooth surfaces. Decides for each line
// between vertices where candidates end or branch. O(n).
void add_weak_lines(FeatureLines& lines, const FeatureLines& candidates, std::span<const Triangle> triangles,
                    const base::Host& host);

}  // namespace orbicube::mesh
