// A layout drawn on the surface in space with the very combinatorics that it has on the polycube, for any genus.
//
// Arcs are shortest paths, one after another, that keep off what is drawn and leave their nodes in the order of the
// layout. First come those of a spanning tree, then one for each generator of the surface's topology (edges neither in
// the tree nor in its cotree), each of which must leave the rest connected, then the others. After each, edges that
// join two drawn vertices and triangles with three drawn sides are split, so that a next path always exists (Kraevoy,
// Sheffer and Gotsman 2003; Praun, Sweldens and Schroeder 2001 for the order). The result has the right cyclic order at
// each node and each rectangle as a disk, whatever the shape; how good it is depends on the guide.
#pragma once

#include "polycube/layout/layout_guide.h"
#include "polycube/surface/editable_surface.h"

namespace orbicube::polycube {

struct Drawing {
  explicit Drawing(std::pmr::memory_resource* memory) : node_vertex(memory), path(memory), rectangle(memory) {}

  Array<Index> node_vertex;  // of each node
  Array<Array<Index>> path;  // of each arc: vertices from its first node to its second
  Array<Index> rectangle;    // of each triangle
};

// Draws on `surface`, which is refined. Throws Error "no-valid-result" when that would refine it beyond measure,
// "cancelled". O(arcs * n log n) at worst.
Drawing trace(const Layout& layout, const LayoutGuide& guide, EditableSurface& surface, const base::Host& host);

// The same with the layout's own place for a guide.
Drawing trace(const Layout& layout, EditableSurface& surface, const base::Host& host);

}  // namespace orbicube::polycube
