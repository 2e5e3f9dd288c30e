#include "volume_map/solid_boundary.h"

#include <string>

#include "base/error.h"
#include "mesh/cells.h"
#include "mesh/topology.h"

namespace orbicube::volume_map {

BoundaryFirst boundary_first(const mesh::Mesh& solid, const base::Host& host) {
  if (solid.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra");
  mesh::require_valid_cells(solid, host);
  BoundaryFirst result(host.memory);
  result.surface = mesh::boundary_triangles(solid, host);
  base::Array<mesh::Index> number(solid.positions.size(), mesh::no_index, host.memory);
  const auto take = [&](mesh::Index& v) {
    if (number[v] == mesh::no_index) {
      number[v] = static_cast<mesh::Index>(result.positions.size());
      result.positions.push_back(solid.positions[v]);
    }
    v = number[v];
  };
  for (mesh::Triangle& t : result.surface) {
    for (mesh::Index& v : t)
      take(v);
  }
  result.outer = result.positions.size();
  result.tetrahedra = solid.tetrahedra;
  for (mesh::Tetrahedron& t : result.tetrahedra) {
    for (mesh::Index& v : t)
      take(v);
  }
  const mesh::Topology topology = mesh::topology(result.outer_positions(), result.surface, host);
  mesh::require_closed_manifold(topology);
  if (topology.components != 1) {
    throw base::Error("not-connected", "the boundary has " + std::to_string(topology.components) +
                                           " components: pieces or cavities, which have no common polycube");
  }
  return result;
}

}  // namespace orbicube::volume_map
