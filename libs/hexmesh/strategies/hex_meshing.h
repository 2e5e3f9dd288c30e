// Hexahedral meshes of solids through the polycubes of their surfaces: the grid of a polycube with integer planes is
// taken back by the map of the surface, filled, padded, and made better; the result is certified. Where no
// polycube serves, the cells of a grid in space do.
#pragma once

#include "hexmesh/strategies/hex_draft.h"

namespace orbicube::hexmesh {

enum class Padding : std::int32_t { automatic = 0, with = 1, without = 2 };

// What is filled with cells: the polycube, space (voxel_hexes.h), or space where the polycube's hexahedra are not near
// to the surface, even twice as many, or poor.
enum class HexMethod : std::int32_t { automatic = 0, polycube = 1, grid = 2 };

struct HexOptions {
  HexMethod method = HexMethod::automatic;
  std::size_t cells = 10000;             // about
  Padding padding = Padding::automatic;  // layers at the boundary; automatic: where they serve (padding.h)
  int rounds = 40;                       // of smoothing
  // In percent: so far the boundary may be from the surface and the surface from the boundary, of the diagonal of its
  // box, and so much the volume may differ. Where a mesh does not do that there are more cells, twice as many each
  // time, up to `max_cells`; the nearest is returned. 0: nothing is requested.
  double distance = 1;
  std::size_t max_cells = 100'000;
  // What of the surface bends by at least the given angle in degrees is followed where the polycube has edges nearby;
  // 0: nothing.
  double feature_angle = 40;
  // Above 0: the worst scaled Jacobian of what there is. Of the polycube only the first way to fill it is tried, and
  // only while that may beat it.
  double to_beat = 0;
};

// Every hexahedron of the result has positive corners by exact signs and a trilinear map that is certainly positive;
// the mesh is conforming, with the components and the genus of the surface, and its boundary does not meet itself
// (hex_embedding.h). Of several the first is taken that is as
// near to the surface as requested, or the nearest. A map without triangles is none: then `fine_triangles` are filled,
// grid-based. The same for any number of threads. Throws Error "no-valid-result" with what failed and where,
// "invalid-argument", "cancelled".
HexResult make_hexahedra(const PolycubeSurface& surface, const HexOptions& options, const base::Host& host);

}  // namespace orbicube::hexmesh
