// Hexahedral meshes with the singular edges of a frame field: the integer grid of a map by frames, made better with its
// boundary on the surface; the result is certified.
#pragma once

#include <cstdint>

#include "hexmesh/strategies/hex_meshing.h"
#include "volume_map/frames/frame_map.h"

namespace orbicube::hexmesh {

struct FrameHexOptions {
  std::size_t cells = 10000;  // about
  int rounds = 40;            // of smoothing
  // As in HexOptions.
  double distance = 1;
  std::size_t max_cells = 100'000;
  // The surface that counts, where the solid fills a coarser version of it; may be empty.
  std::span<const Vector3> fine_positions = {};
  std::span<const mesh::Triangle> fine_triangles = {};
  // Where frames are not given: the number of fields to try.
  std::size_t max_fields = 7;
  std::size_t max_faults = SIZE_MAX;  // of a field, in edges and vertices of no hexahedra; more, and no other is tried
  // One attempt of few steps for a map, and no other field where it is refused. Measured: CAD parts with a map have it
  // after 1 to 41 steps; one that is refused takes 500.
  bool quick = false;
};

struct FrameHexes {
  explicit FrameHexes(std::pmr::memory_resource* memory) : result(memory), map(memory) {}

  HexResult result;
  volume_map::FrameMap map;
  std::size_t inner_irregular_edges = 0;  // with other than four hexahedra
  // Where frames were not given: how many fields were tried, the last being that of the hexahedra, and how long that
  // took without maps and hexahedra.
  std::size_t fields = 0;
  double field_seconds = 0;
};

// Every hexahedron has positive corners by exact signs and a trilinear map that is certainly positive; the boundary is
// near to that of the solid, as make_hexahedra's is to its surface. Throws what map_by_frames and extract_hexahedra do.
FrameHexes make_hexahedra_by_frames(const volume_map::FramedSolid& solid, const FrameHexOptions& options,
                                    const base::Host& host);

// The same where there are no frames: with those of the first of several fields that a map can follow, the smoothest
// first. They lie along the boundary, are changed where no mesh of hexahedra could follow, and have an axis along edges
// of the boundary that turn by more than `feature_angle` (radians; 0: none). Throws what frame_field::compute does, and
// where no field has a map what is wrong with the first, or that with the fewest faults.
FrameHexes make_hexahedra_along_frames(std::span<const Vector3> positions, std::span<const Tetrahedron> tetrahedra,
                                       double feature_angle, const FrameHexOptions& options, const base::Host& host);

}  // namespace orbicube::hexmesh
