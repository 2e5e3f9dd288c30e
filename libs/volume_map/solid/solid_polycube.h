// Polycubes of the boundaries of solids, which may have cavities.
#pragma once

#include "polycube/map/construction.h"

namespace orbicube::volume_map {

// Of the boundary of one connected solid: a surface that is outward-oriented, alone or with cavities within it, which
// are oriented inward. Each part gets the polycube that it would have alone (polycube/map/construction.h), with up to
// `options.corners`. Those of cavities are put into that of the outer surface, where its map would have them
// (cavity_placement.h), and are made smaller until they fit. The certificate is that of all together. Throws the same,
// and Error "no-valid-result" for a cavity that does not fit.
polycube::Construction construct_polycube(std::span<const mesh::Vector3> positions,
                                          std::span<const mesh::Triangle> triangles,
                                          const polycube::ConstructionOptions& options, const base::Host& host);

}  // namespace orbicube::volume_map
