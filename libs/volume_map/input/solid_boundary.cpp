#include "volume_map/input/solid_boundary.h"

#include <algorithm>
#include <string>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/topology/cells.h"
#include "volume_map/input/solid_pieces.h"

namespace orbicube::volume_map {

BoundaryFirst boundary_first(const mesh::Mesh& solid, const base::Host& host) {
  if (solid.tetrahedra.empty()) throw base::Error("no-cells", "no tetrahedra");
  mesh::require_valid_cells(solid, host);
  BoundaryFirst result(host.memory);
  result.surface = mesh::boundary_triangles(solid, host);
  // With the numbers that the input has.
  require_closed_surface(solid.positions, result.surface, host);
  const Pieces pieces = pieces_of(solid.tetrahedra, solid.positions.size(), host);
  if (pieces.count > 1) {
    const auto first = static_cast<std::size_t>(std::find(pieces.of.begin(), pieces.of.end(), 1U) - pieces.of.begin());
    throw base::Error("not-connected", base::counted(pieces.count, "piece") +
                                           ", which have no common polycube; tetrahedron " + std::to_string(first) +
                                           ", at " + place_text(solid.positions[solid.tetrahedra[first][0]]) +
                                           ", is not connected with the first one");
  }
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
  return result;
}

}  // namespace orbicube::volume_map
