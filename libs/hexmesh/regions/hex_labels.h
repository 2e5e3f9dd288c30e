// Which region each hexahedron belongs to, so that regions meet in manifold sheets of quads.
#pragma once

#include "hexmesh/certificate/hex_mesh.h"
#include "hexmesh/regions/region_interfaces.h"

namespace orbicube::hexmesh {

// Returns the label of the region that most of each hexahedron is in. Hexahedra that most neighbors are in another
// region than, and those that touch their region at an edge or a vertex only, are given to the other one.
Array<Index> labels_of_hexahedra(const HexMesh& mesh, const mesh::Mesh& solid, const RegionInterfaces& interfaces,
                                 const base::Host& host);

}  // namespace orbicube::hexmesh
