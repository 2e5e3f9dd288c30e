// A closed oriented surface with the data that are needed repeatedly while it is labeled and mapped.
#pragma once

#include <span>

#include "base/host.h"
#include "mesh/topology/connectivity.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

struct Surface {
  // Takes the arrays. Throws what mesh::Connectivity does.
  Surface(Array<Vector3> vertex_positions, Array<Triangle> faces, const base::Host& host);
  Surface(Surface&&) = default;
  Surface& operator=(Surface&&) = default;
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  Index start(Index half_edge) const { return connectivity.start(half_edge); }
  Index end(Index half_edge) const { return connectivity.end(half_edge); }
  Index opposite(Index half_edge) const { return connectivity.opposite(half_edge); }
  // Across the edge of the half-edge.
  Index neighbor(Index half_edge) const { return connectivity.opposite(half_edge) / 3; }
  // The next half-edge out of the same vertex, counter-clockwise.
  Index turned(Index half_edge) const { return connectivity.opposite(mesh::Connectivity::previous(half_edge)); }
  double length(Index half_edge) const { return (positions[end(half_edge)] - positions[start(half_edge)]).norm(); }

  Array<Vector3> positions;
  Array<Triangle> triangles;
  mesh::Connectivity connectivity;
  Array<Vector3> normals;  // of each triangle, unit; the z axis for one without area
  Array<double> areas;
  double area = 0;
};

// Unit normals of triangles on other positions of their vertices.
Array<Vector3> unit_normals(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                            const base::Host& host);

// Cotangent of the angle at a in the triangle a, b, c; bounded for slivers.
double cotangent(const Vector3& a, const Vector3& b, const Vector3& c);

}  // namespace orbicube::polycube
