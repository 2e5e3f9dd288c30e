// Places on sharp lines that the feature graph does not have: short ones inside a patch, and those that were left out
// of it. They cost no cells: edges of the mesh that lie along such a line by chance go to it.
#pragma once

#include "hexmesh/certificate/hex_mesh.h"
#include "hexmesh/features/feature_targets.h"

namespace orbicube::hexmesh {

struct PlaceOnLine {
  Index vertex = no_index;
  Vector3 position = Vector3::Zero();
};

// For each line that has a path of boundary edges near to it: the vertices of the path, all of one patch or on the line
// already, with target positions at equal distances along the line, both ends included. Of several paths the one whose
// vertices are nearest to these is taken (Viterbi 1967). No vertex gets two positions. Positions are in the unit of the
// shape of the targets. O(n) for each line; there are few.
Array<PlaceOnLine> places_on_lines_left_out(const HexMesh& mesh, const FeatureTargets& targets, const base::Host& host);

}  // namespace orbicube::hexmesh
