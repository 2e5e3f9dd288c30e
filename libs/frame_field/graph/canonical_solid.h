// The solid in axes and in an order of its own, so that neither turning it nor renumbering its vertices or tetrahedra
// changes the field that is computed: starts and searches decide between possibilities that may be nearly as good as
// each other, by rounding if nothing else.
//
// The axes are those of the frame that is nearest to the boundary's normals, of its 24 rotations the one that the
// solid's moments choose; what a renumbering leaves of them is the same bits, what a rigid motion leaves differs by
// rounding. A box comes to lie along the axes.
#pragma once

#include <array>
#include <span>

#include "frame_field/graph/constraints.h"

namespace orbicube::frame_field {

struct CanonicalSolid {
  explicit CanonicalSolid(std::pmr::memory_resource* memory)
      : positions(memory), tetrahedra(memory), vertex(memory), tetrahedron(memory) {}

  Array<Vector3> positions;       // in the axes of the solid
  Array<Tetrahedron> tetrahedra;  // positive, along a Hilbert curve: in the order of a DualGraph's nodes
  Array<Index> vertex;            // numbers in the given mesh
  Array<Index> tetrahedron;
  Quaternion axes{1, 0, 0, 0};  // turns the solid's axes to the given ones

  // From the given axes to the solid's.
  Vector turned(const Vector& v) const;
  Quaternion turned(const Quaternion& frame) const;
  void turn(Constraints& constraints) const;
  // And back.
  Quaternion turned_back(const Quaternion& frame) const;

  std::array<double, 9> matrix{1, 0, 0, 0, 1, 0, 0, 0, 1};  // to the solid's axes, by rows
};

// `connectivity` is that of the given mesh. O(n log n), 80 bytes a tetrahedron while it runs and 30 kept. Throws Error
// "cancelled".
CanonicalSolid make_canonical(std::span<const Vector3> positions, const mesh::TetrahedralConnectivity& connectivity,
                              const base::Host& host);

}  // namespace orbicube::frame_field
