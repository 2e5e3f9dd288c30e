// A mesh of tetrahedra with a frame in each, split for maps that follow the frames: what of it such a map holds, the
// boundary and the singular edges, meets each tetrahedron in at most one vertex, edge or face.
#pragma once

#include "base/host.h"
#include "mesh/topology/tetrahedral_connectivity.h"
#include "quaternion/quaternion.h"
#include "volume_map/types.h"

namespace orbicube::volume_map {

using quaternion::Quaternion;

struct FramedSolid {
  explicit FramedSolid(std::pmr::memory_resource* memory) : positions(memory), tetrahedra(memory), frames(memory) {}

  Array<Vector3> positions;
  Array<Tetrahedron> tetrahedra;
  Array<Quaternion> frames;  // of each tetrahedron, units
};

// Of each face on the boundary (4 t + k; 0 for others) 2 axis + (1 where it is outward-oriented) of the frame's axis
// that is next to the normal. `border` gets an entry a ring: 1 for edges of the boundary on whose two sides these axes
// are not the same one, carried along by the matchings (of faces).
Array<std::uint8_t> label_boundary(std::span<const Vector3> positions,
                                   const mesh::TetrahedralConnectivity& connectivity, const mesh::EdgeRings& rings,
                                   std::span<const Quaternion> frames, std::span<const std::uint8_t> matchings,
                                   Array<std::uint8_t>& border, const base::Host& host);

// The two faces of the boundary that have an edge of it, in the order of its ring.
std::array<Index, 2> boundary_faces(const mesh::TetrahedralConnectivity& connectivity, const mesh::EdgeRings& rings,
                                    std::size_t ring);

// On the boundary edges are split whose vertices are both on borders of what lies in one plane, or at ends of singular
// curves. Parts of a tetrahedron have its frame, so that singular edges stay as they are. Vertices are added behind
// those that are there, tetrahedra too. A split that would not leave all positive, by exact signs, is left out. O(n)
// for each of some ten rounds. Throws what mesh::TetrahedralConnectivity does.
void split_for_frames(FramedSolid& solid, const base::Host& host);

// Halves the edges at the vertices of these tetrahedra, but for those of the boundary and singular ones: room where a
// map is in need of it. As above.
void split_around(FramedSolid& solid, std::span<const Index> tetrahedra, const base::Host& host);

}  // namespace orbicube::volume_map
