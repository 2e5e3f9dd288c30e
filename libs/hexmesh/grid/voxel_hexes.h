// Hexahedra of a solid that no polycube serves, as one with many thin protrusions: the cells of a grid in space that
// are inside, with a layer of hexahedra around them (Maréchal 2009, "Advances in octree-based all-hexahedral mesh
// generation", of one size). Whatever the shape, there are such cells with the topology of its surface; but they lie as
// the grid does, and edges of three and five hexahedra run all along the boundary.
#pragma once

#include "hexmesh/certificate/hex_mesh.h"

namespace orbicube::hexmesh {

struct VoxelHexes {
  explicit VoxelHexes(std::pmr::memory_resource* memory) : mesh(memory) {}

  HexMesh mesh;             // in units of a cell; all quads on patch 0
  std::size_t padding = 0;  // number of the last hexahedra are the layer
  double scale = 1;         // from lengths in space to cells
};

// About the given number of hexahedra, the layer included. Of the closed surface of one solid: a part that is
// outward-oriented, and walls of cavities, which look into these. Throws Error "no-valid-result" where no such cells
// have its topology, "cancelled". O(1000 n), and some 10 bytes for each cell of the box of the surface, at most 40
// million.
VoxelHexes voxel_hexahedra(std::span<const Vector3> positions, std::span<const mesh::Triangle> triangles,
                           std::size_t cells, const base::Host& host);

}  // namespace orbicube::hexmesh
