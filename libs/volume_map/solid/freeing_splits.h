// Tetrahedra split where their vertices are all on the boundary, so that a map of the boundary leaves room inside:
// every inner edge between two boundary vertices, then every inner face and every tetrahedron of boundary vertices
// alone.
#pragma once

#include "base/host.h"
#include "volume_map/types.h"

namespace orbicube::volume_map {

// Vertices are added at midpoints and centroids, behind those that are there; the boundary stays. A split that would
// not leave every tetrahedron positive, by exact signs, is left out. All tetrahedra must be positive. O(n) for each
// of about ten rounds. Throws what mesh::TetrahedralConnectivity does. Returns how many vertices were added.
std::size_t split_for_freedom(Array<Vector3>& positions, Array<Tetrahedron>& tetrahedra, const base::Host& host);

// Halves the inner edges that a marked vertex has (an entry a vertex), those that there are now. Returns how many
// vertices were added, behind the others. Throws the same.
std::size_t split_edges_at(Array<Vector3>& positions, Array<Tetrahedron>& tetrahedra,
                           std::span<const std::uint8_t> marked, const base::Host& host);

}  // namespace orbicube::volume_map
