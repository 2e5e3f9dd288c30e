// A solid cut open so that frames are single-valued (Nieser, Reitebuch and Polthier 2011, "CubeCover"): along a
// spanning tree of its tetrahedra frames are named alike, and of the other faces only those stay cut that a singular
// edge or a hole of the solid requires.
#pragma once

#include <array>

#include "frame_field/singularities/singularities.h"
#include "volume_map/frames/framed_solid.h"

namespace orbicube::volume_map {

// Faces are numbered 4 t + k, as seen from their tetrahedron t (mesh/topology/tetrahedral_connectivity.h). Each
// tetrahedron is a chart. Coordinates f of a map that follows the frames change across a cut face by
//   f beyond = M(inverse of rotation) f + gap,
// and not at all across others.
struct FrameCut {
  explicit FrameCut(std::pmr::memory_resource* memory)
      : frames(memory),
        rotation(memory),
        sheet(memory),
        forward(memory),
        sheet_faces(memory),
        one_sided(memory),
        copies(memory),
        vertex_of_copy(memory),
        singular(memory) {}

  std::size_t sheets() const { return sheet_faces.size(); }

  Array<Quaternion> frames;            // of each tetrahedron, turned by a rotation of the cube in its own axes
  Array<std::uint8_t> rotation;        // of each face: the matching of these frames; 0 where the face is not cut
  Array<Index> sheet;                  // of each face, no_index where it is not cut; all faces of a sheet have one gap
  Array<std::uint8_t> forward;         // of each face of a sheet: 1 where it looks the way that the sheet does
  Array<Index> sheet_faces;            // the first face of each sheet, forward
  Array<Index> one_sided;              // sheets that are their own other side
  Array<std::array<Index, 4>> copies;  // of each tetrahedron: its corners, one and the same across faces not cut
  Array<Index> vertex_of_copy;
  Array<std::uint8_t> singular;  // of each edge ring
};

FrameCut cut_open(const mesh::TetrahedralConnectivity& connectivity, const mesh::EdgeRings& rings,
                  std::span<const Quaternion> frames, const base::Host& host);

}  // namespace orbicube::volume_map
