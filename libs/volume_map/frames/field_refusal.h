// Fields that no map follows, refused with the place.
#pragma once

#include "frame_field/singularities/singularities.h"
#include "volume_map/frames/framed_solid.h"

namespace orbicube::volume_map {

// Throws Error "no-valid-result" unless a mesh of hexahedra could have these frames around each edge and vertex.
void require_meshable(const FramedSolid& solid, const mesh::TetrahedralConnectivity& connectivity,
                      const mesh::EdgeRings& rings, std::span<const std::uint8_t> matchings, const base::Host& host);

}  // namespace orbicube::volume_map
