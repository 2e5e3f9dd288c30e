// In place of feature_hexes.cpp in the module for web pages, where nothing requests sharp edges.
#include "base/error.h"
#include "hexmesh/features/feature_hexes.h"

namespace orbicube::hexmesh {

FeatureHexes feature_hexahedra(std::span<const Vector3>, std::span<const mesh::Triangle>, const FeatureHexOptions&,
                               const base::Host&) {
  throw base::Error("unsupported", "hexahedra with sharp edges are not part of the module for web pages");
}

}  // namespace orbicube::hexmesh
