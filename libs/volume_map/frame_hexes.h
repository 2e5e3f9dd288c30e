// Hexahedral meshes with the singular edges of a frame field: the integer grid of a map by frames, made better with its
// boundary on the surface; what is answered is certified.
#pragma once

#include "volume_map/frame_map.h"
#include "volume_map/hex_meshing.h"

namespace orbicube::volume_map {

// Sets the frames: smooth, along the boundary, changed where no mesh of hexahedra could follow (the first of several
// fields that nowhere is such), and with an axis along edges of the boundary that turn by more than `feature_angle`
// (radians; 0: none). Throws what frame_field::compute does.
void find_frames(FramedSolid& solid, double feature_angle, const base::Host& host);

struct FrameHexOptions {
  std::size_t cells = 10000;  // about
  int rounds = 40;            // of smoothing
};

struct FrameHexes {
  explicit FrameHexes(std::pmr::memory_resource* memory) : result(memory), map(memory) {}

  HexResult result;
  FrameMap map;
  std::size_t inner_irregular_edges = 0;  // with other than four hexahedra
};

// Every hexahedron has positive corners by exact signs and a trilinear map that is certainly positive; the boundary is
// on that of the solid. Throws what map_by_frames and extract_hexahedra do.
FrameHexes make_hexahedra_by_frames(const FramedSolid& solid, const FrameHexOptions& options, const base::Host& host);

}  // namespace orbicube::volume_map
