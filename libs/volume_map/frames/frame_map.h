// Maps of solids that follow a frame field (Nieser, Reitebuch and Polthier 2011, "CubeCover"): coordinates whose
// gradients are the axes of the frames, each tetrahedron a chart. Charts meet by rotations of the cube and integer
// translations, singular edges and the boundary lie on lines and planes of integers, and no tetrahedron is inverted:
// the integer grid of the charts is a mesh of hexahedra (grid_extraction.h).
#pragma once

#include "mesh/topology/tetrahedral_connectivity.h"
#include "volume_map/frames/framed_solid.h"
#include "volume_map/frames/transitions.h"

namespace orbicube::volume_map {

struct FrameMapOptions {
  double cell_length = 0;  // of the grid in space
  int max_attempts = 5;    // each with more tetrahedra around those that stayed inverted in the last
  // Whether an attempt begins again, with up to 120 steps, where tetrahedra stay inverted after the first 60.
  bool patient = true;
};

struct FrameMap {
  explicit FrameMap(std::pmr::memory_resource* memory)
      : solid(memory), charts(memory), transition(memory), label(memory), patch(memory) {}

  FramedSolid solid;  // split where the map requires that; frames named alike where faces are not cut
  // Of each tetrahedron the coordinates of its corners, and of each of its faces (4 t + k) how they change beyond. All
  // are multiples of 2^-30, so that this is exact.
  Array<std::array<Vector3, 4>> charts;
  Array<Transition> transition;
  // Of each face on the boundary: 2 axis + (1 where it is outward-oriented), constant and integer there, and the number
  // of the part of the boundary in one plane of charts; no_index for other faces.
  Array<std::uint8_t> label;
  Array<Index> patch;
  std::size_t patches = 0;

  std::size_t singular_edges = 0, cut_faces = 0, sheets = 0, integers = 0, bounds = 0;
  bool integers_optimal = false;  // the search for the best ones came to its end
  double energy = 0;              // of the best map without integers, and what these add, both over the volume
  double integer_cost = 0;
  std::size_t inverted_at_start = 0, steps = 0;
};

// The frames of the solid have an axis along the normal at the boundary, about. What leaves is certified: all
// tetrahedra are positive by exact signs, transitions exact, and around each inner edge the angles of the charts add up
// to four right angles, or three or five where it is singular. The same for any number of threads. Throws Error
// "no-valid-result" with the place for fields that no such map has (singular edges about no axis, curves that change
// from three to five, layers that would collapse) and for maps that stay inverted; "invalid-argument", "cancelled", and
// what mesh::TetrahedralConnectivity does.
FrameMap map_by_frames(const FramedSolid& solid, const FrameMapOptions& options, const base::Host& host);

}  // namespace orbicube::volume_map
