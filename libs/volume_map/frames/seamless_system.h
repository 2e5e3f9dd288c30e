// The unknowns of a map that follows frames (CubeCover, eqs. 5.7 to 5.11 of the dissertation): coordinates of vertices
// in each chart as one free variable and sums of integers. Integer are the gaps of cuts, the planes of the boundary,
// and what is constant along a singular edge.
#pragma once

#include "volume_map/frames/frame_cut.h"
#include "volume_map/frames/integer_forms.h"

namespace orbicube::volume_map {

struct SeamlessSystem {
  explicit SeamlessSystem(std::pmr::memory_resource* memory)
      : variable(memory), sign(memory), form(memory), forms(memory), gap(memory), label(memory), patch(memory) {}

  // By coordinate 3 copy + axis: sign times a free variable (no_index: none) plus a form in the integers.
  Array<Index> variable;
  Array<std::int8_t> sign;
  Array<Index> form;
  std::size_t variables = 0;  // free ones
  std::size_t integers = 0;   // independent ones
  IntegerForms forms;
  Array<std::array<Index, 3>> gap;  // of each sheet, forward: forms
  // Of each face on the boundary: 2 axis + (1 where the axis is outward-oriented), in its tetrahedron's chart, and the
  // number of the connected part of the boundary that lies in one plane, or goes round a hole.
  Array<std::uint8_t> label;
  Array<Index> patch;
  std::size_t patches = 0;
};

// Throws Error "no-valid-result" where the equations have only solutions beyond use, "cancelled".
SeamlessSystem make_seamless_system(std::span<const Vector3> positions,
                                    const mesh::TetrahedralConnectivity& connectivity, const mesh::EdgeRings& rings,
                                    const FrameCut& cut, const base::Host& host);

}  // namespace orbicube::volume_map
