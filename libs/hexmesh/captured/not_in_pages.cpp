// In place of feature_choice.cpp in the module for web pages, where nothing requests sharp edges.
#include "base/error.h"
#include "hexmesh/captured/feature_choice.h"

namespace orbicube::hexmesh {

FeatureFigures keep_features(const mesh::Mesh&, const FeatureChoice&, std::optional<HexResult>&, const base::Host&) {
  throw base::Error("unsupported", "hexahedra with sharp edges are not part of the module for web pages");
}

}  // namespace orbicube::hexmesh
