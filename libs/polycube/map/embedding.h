// Whether the patches of a polycube meet in their common edges and corners only, and its cavities lie within it.
//
// A face is known by the straight edges around it: its triangles turn once around each of their vertices, so that each
// point of its plane is covered as often as the loops around the face wind around it. The planes through all corners
// cut the faces into cells, and the faces do not meet when no cell is covered twice, no edge of the grid has more than
// two cells, and the cells around each of its vertices are one ring. Where faces of one axis then look back and forth
// by turns along each row of cells, what is between is inside once. All of that is counted in whole numbers: the
// triangles themselves do not matter.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "base/host.h"
#include "mesh/topology/connectivity.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

// Of a closed surface whose triangles lie in axis-aligned planes with these labels and patches, and turn once around
// each vertex (certificate.h). Returns where it meets itself or parts of it are not inside and outside by turns, empty
// when all is well; nothing when the grid would have more than `max_cells` cells, which only polycubes of very many
// corners have. Throws Error "cancelled".
std::optional<std::string> embedding_fault(std::span<const Vector3> polycube, std::span<const Triangle> triangles,
                                           std::span<const AxisLabel> labels, std::span<const Index> patches,
                                           const mesh::Connectivity& connectivity, std::size_t max_cells,
                                           const base::Host& host);

}  // namespace orbicube::polycube
