// The deformation that brings a boundary with an embedded feature graph to the surface without ever folding.
#pragma once

#include "hexmesh/features/feature_targets.h"
#include "hexmesh/quality/corner_elements.h"

namespace orbicube::hexmesh {

struct FeatureFitOptions {
  int rounds = 40;  // of raising weights
};

// Untangles the mesh with a loose boundary, then raises the weights of the targets with positive determinants as a
// barrier. Returns whether no corner is inverted.
bool fit_to_features(HexMesh& mesh, const BoxSizes& sizes, FeatureTargets& targets, const FeatureFitOptions& options,
                     const base::Host& host);

// Moves the boundary onto its targets as far as the hexahedra allow, improves the inside with the boundary fixed, and
// tries other positions for the vertices of the worst hexahedra, those of the boundary on their arc or patch, until the
// worst scaled Jacobian is near to its bound. Returns the number of boundary vertices off their targets.
std::size_t snap_to_features(HexMesh& mesh, const BoxSizes& sizes, FeatureTargets& targets, double bound,
                             const base::Host& host);

// Moves the vertices of the hexahedra that may be folded: by unfold_hexahedra(), and where that is not enough wherever
// it helps; then back to their targets as far as the hexahedra allow. Returns the number of boundary vertices off
// these.
std::size_t free_folded_hexahedra(HexMesh& mesh, const BoxSizes& sizes, FeatureTargets& targets, double bound,
                                  const base::Host& host);

// Improves the positions inside with the boundary fixed.
void smooth_inside(HexMesh& mesh, const BoxSizes& sizes, const FeatureTargets& targets, int steps,
                   const base::Host& host);

}  // namespace orbicube::hexmesh
