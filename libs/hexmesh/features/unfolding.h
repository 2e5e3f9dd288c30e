// Hexahedra of a fitted mesh that may be folded between good corners.
#pragma once

#include <functional>

#include "hexmesh/features/feature_fitting.h"

namespace orbicube::hexmesh {

// Makes the hexahedra that are not certainly positive, and those around them, better by the foldover-free energy, with
// the tetrahedra along their edges as elements; all others stay. Vertices of the boundary may leave their targets, the
// farther the more attempts it takes. Returns whether all are certainly positive.
bool unfold_hexahedra(HexMesh& mesh, const BoxSizes& sizes, const FeatureTargets& targets, const base::Host& host);

// The same with targets of any kind: pull(vertex, position, weight, to) adds what pulls one of these vertices, in
// ascending order.
using PullVertex = std::function<void(Index, const Vector3&, double, Pull&)>;
bool unfold_hexahedra(HexMesh& mesh, const BoxSizes& sizes, std::span<const Index> vertices, const PullVertex& pull,
                      const base::Host& host);

}  // namespace orbicube::hexmesh
