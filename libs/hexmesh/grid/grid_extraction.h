// The mesh of hexahedra whose corners are the integer points of a map by frames, as by Lyon, Bommes and Kobbelt (2016,
// "HexEx") but for their repairs: no tetrahedron is inverted, so that each cell is found whole.
#pragma once

#include "hexmesh/certificate/hex_mesh.h"
#include "volume_map/frames/frame_map.h"

namespace orbicube::hexmesh {

// From the middle of each cell straight lines go to its corners, from chart to chart; all decisions are exact. Vertices
// are in space where the map has them, faces on the boundary have the map's patches. Conforming, and as many hexahedra
// as the charts have volume, or Error "no-valid-result". "cancelled".
HexMesh extract_hexahedra(const volume_map::FrameMap& map, const base::Host& host);

}  // namespace orbicube::hexmesh
