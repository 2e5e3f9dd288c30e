// Where the arcs and nodes of a layout should be drawn on a surface. The layout's combinatorics are met whatever the
// guide; how good the drawing is depends on it.
#pragma once

#include "polycube/layout/layout.h"

namespace orbicube::polycube {

struct LayoutGuide {
  explicit LayoutGuide(std::pmr::memory_resource* memory)
      : node_position(memory), node_normal(memory), node_vertex(memory), arc(memory) {}

  // Of each node.
  Array<Vector3> node_position, node_normal;
  Array<Index> node_vertex;  // of the surface, where it has to be; no_index where it is free
  // Of each arc: points along it from its first node to its second, at least two.
  Array<Array<Vector3>> arc;
};

// Of a layout that stands where the surface is: nodes where they are, arcs straight.
LayoutGuide straight_guide(const Layout& layout, std::pmr::memory_resource* memory);

}  // namespace orbicube::polycube
