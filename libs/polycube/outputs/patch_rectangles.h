// The surface of a polycube cut by the planes of all its patches: rectangles that fit side to side.
#pragma once

#include "polycube/outputs/patch_graph.h"

namespace orbicube::polycube {

// A part of a patch between two neighboring planes along both other axes.
struct PatchRectangle {
  AxisLabel label;
  Index plane;          // layer along the patch's axis
  Index first, second;  // intervals between layers along the other two axes
  Index patch;
};

// The axes along a patch: with the first turned to the second, a patch that looks in the positive direction is
// counter-clockwise.
inline std::size_t first_axis(AxisLabel label) {
  return static_cast<std::size_t>((axis_of(label) + 1) % 3);
}
inline std::size_t second_axis(AxisLabel label) {
  return static_cast<std::size_t>((axis_of(label) + 2) % 3);
}

// The planes that patches lie in, ascending, along each axis.
std::array<Array<double>, 3> layers_of(const PatchGraph& graph, std::pmr::memory_resource* memory);

// Sorted by label, plane and place, so that the order depends on the polycube alone. `corners`, `dart_origin`,
// `labels`, `coordinates` and the loops of the graph are used. Throws Error "invalid-argument" when a corner is on no
// layer, "cancelled".
Array<PatchRectangle> rectangles_of(const PatchGraph& graph, const std::array<Array<double>, 3>& layers,
                                    const base::Host& host);

}  // namespace orbicube::polycube
