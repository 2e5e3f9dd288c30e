// In place of feature_choice.cpp in the module for web pages, where nothing requests sharp edges.
#include "base/error.h"
#include "hexmesh/captured/feature_choice.h"

namespace orbicube::hexmesh {

bool can_keep_features() {
  return false;
}

FeatureKeeper::FeatureKeeper(const mesh::Mesh&, const FeatureChoice& choice, const base::Host& host)
    : choice_(choice), host_(host), left_out_(host.memory) {
  throw base::Error("unsupported", "hexahedra with sharp edges are not part of the module for web pages");
}

bool FeatureKeeper::offer(const HexResult&, bool, const HexResult*) {
  return false;
}

std::optional<HexResult> FeatureKeeper::embed() {
  return {};
}

bool FeatureKeeper::nearly_complete() const {
  return false;
}

FeatureFigures FeatureKeeper::figures() const {
  return figures_;
}

}  // namespace orbicube::hexmesh
