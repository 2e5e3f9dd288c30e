// In place of feature_choice.cpp and conforming_regions.cpp in the module for web pages, where nothing requests sharp
// edges or regions.
#include "base/error.h"
#include "hexmesh/captured/feature_choice.h"
#include "hexmesh/regions/conforming_regions.h"

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

RegionFigures conform_to_regions(HexResult&, const mesh::Mesh&, const base::Host& host) {
  return RegionFigures{Array<std::int32_t>(host.memory)};
}

}  // namespace orbicube::hexmesh
