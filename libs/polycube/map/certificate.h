// Whether a map to a polycube is what it should be, decided by exact arithmetic on the coordinates as they are.
//
// Valid means: the triangles are a closed, oriented manifold; each lies exactly in an axis-aligned plane and has area;
// around each vertex the triangles turn once (four quarter turns inside a patch of the polycube, two in each face along
// an edge, one, two or three in each face at a corner); no two triangles meet but in the vertices and edges that they
// share (embedding.h); and the surface is connected and outward-oriented, or one part of it is and the others are
// cavities within that, which are inward-oriented. Then the triangles are the boundary of a connected solid with
// axis-aligned faces, and each of its points is covered once.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/host.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

struct Certificate {
  explicit Certificate(std::pmr::memory_resource* memory) : labels(memory), patches(memory) {}

  bool valid() const { return reason.empty(); }

  std::string reason;  // what is wrong and where, or empty
  std::size_t cavities = 0;
  std::int64_t genus = 0;       // with cavities, of all parts together
  std::size_t corners = 0;      // vertices where three patches of the polycube or more meet
  std::size_t patch_count = 0;  // of the polycube
  Array<AxisLabel> labels;      // of each triangle, while reason is empty
  Array<Index> patches;         // of each triangle, numbered in the order of their first triangles
};

// `polycube` are the positions of the vertices of `triangles` on the polycube. O(n log n), unless the planes through
// all corners cut its faces into more than ten million cells. The same for any number of threads. Throws Error
// "invalid-argument" for an index that is out of range or a position that is not finite, "cancelled".
Certificate certify(std::span<const Vector3> polycube, std::span<const Triangle> triangles, const base::Host& host);

// The same for a map, which has the genus of its surface since the triangles are the same. Fills in its labels and
// patches when it is valid.
Certificate certify(SurfaceMap& map, const base::Host& host);

}  // namespace orbicube::polycube
