// The grids of a polycube: which of its patches get a layer of hexahedra, and the cells with these layers.
#pragma once

#include "hexmesh/strategies/hex_meshing.h"
#include "polycube/outputs/patch_graph.h"

namespace orbicube::hexmesh {

// The patches of the polycube that get a layer, and which part of its boundary they are.
struct PaddedFaces {
  PaddedFaces(const HexMesh& mesh, Array<std::uint8_t> chosen);

  Array<std::uint8_t> faces;
  double part = 0;
};

// A map that hexahedra may follow, and what all meshes along it have in common.
struct Guide {
  Guide(const PolycubeSurface& of, bool is_sharp, const base::Host& host)
      : surface(of), sharp(is_sharp), graph(polycube::make_patch_graph(of.map, host)) {}

  PolycubeSurface surface;
  bool sharp;  // edges were brought to those of the polycube
  polycube::PatchGraph graph;
};

// Whether protrusions have no room on the polycube: what changes angles twofold on average has no hexahedra there.
bool has_lost_limbs(const polycube::SurfaceMap& map, const base::Host& host);

// One of the strategies to mesh the solid.
struct Strategy {
  const Guide* guide;
  int padding;  // the first or the second choice
  PaddedFaces padded;

  bool same(const Guide* other, int other_padding) const { return guide == other && padding == other_padding; }
};

// Whether a mesh is valid and as near to the surface as requested, and so much so that there is no need for another.
struct Nearness {
  bool near = false, by_itself = false;
  double scaled_jacobian = 0;  // of a valid one
};

// The meshes that were made of a strategy with one number of cells.
struct Tried {
  bool free = false, fixed = false, insisted = false, unraised = false;
  bool near = false;  // any
  Nearness last;      // of the last valid one
};

// Adds what may be padded, the most promising first. `across`: minimum number of cells across a passage.
void add_strategies(Array<Strategy>& strategies, const Guide& guide, const HexOptions& options, std::size_t cells,
                    int across, const base::Host& host);

// The grid of one of the strategies, with its layers, in units of a cell.
struct PolycubeGrid {
  PolycubeGrid(const Strategy& strategy, std::size_t cells, int across, const base::Host& host);

  HexMesh mesh;
  std::size_t padding = 0;  // number of the last hexahedra
  double scale = 1;
};

}  // namespace orbicube::hexmesh
