// The choice between the mesh of a method and one that has the feature graph of the surface embedded.
#pragma once

#include <optional>

#include "hexmesh/captured/feature_surface.h"
#include "hexmesh/strategies/hex_draft.h"

namespace orbicube::hexmesh {

struct FeatureChoice {
  FeatureRequest request;
  bool may_replace = true;  // otherwise the mesh of the method is measured only
  // As in Options.
  std::size_t cells = 10000, max_cells = 100'000;
  double distance = 1;
  int rounds = 40;
};

// Measures the features that a mesh of the input has; where it lacks some, or there is no mesh, makes one grid-based
// with the graph embedded (feature_hexes.h), and takes that if it has more of them: a larger captured length, or as
// much and more corners. Each missing feature gets a reason. The same for any number of threads. Throws Error
// "cancelled"; other errors are reasons.
FeatureFigures keep_features(const mesh::Mesh& input, const FeatureChoice& choice, std::optional<HexResult>& made,
                             const base::Host& host);

}  // namespace orbicube::hexmesh
