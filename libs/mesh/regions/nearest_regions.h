// Regions of new faces and cells: those of the nearest triangles and tetrahedra of the input.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// A face of another mesh by its center and its vector area.
struct FacePlace {
  Vector3 center, area;
};

FacePlace face_place(std::span<const Vector3> positions, std::span<const Index> corners);

// Returns for each face the region of the nearest triangle of `from`, among those that are less than 60 degrees turned
// against it, where one is about as near as the nearest of all: beside an edge, the center of a face can be as near to
// the triangles beyond it. Empty if all are 0. Squares of the coordinates must be in the range of
// double. O(n log n) on average. Throws Error "cancelled".
Array<std::int32_t> nearest_face_regions(const Mesh& from, std::span<const FacePlace> faces, const base::Host& host);

// Returns for each point the region of the tetrahedron or hexahedron of `from` that it is in, or that is nearest, the
// lowest of equals, where hexahedra have flat faces. Empty if all are 0. As above.
Array<std::int32_t> nearest_cell_regions(const Mesh& from, std::span<const Vector3> points, const base::Host& host);

}  // namespace orbicube::mesh
