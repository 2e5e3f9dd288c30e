// Arcs and corners of a labeled surface: an arc separates two patches and runs from corner to corner.
#pragma once

#include <array>
#include <span>

#include "polycube/labels/patches.h"

namespace orbicube::polycube {

struct Arc {
  Index left, right;  // patches; left of the direction of the arc's half-edges
  Index first, last;  // vertices; a loop without corners has the same twice
  Index begin, size;  // in ArcNetwork::half_edges
  double length;
  int axis;  // that the arc runs along on the polycube

  // The direction, along the axis, that the arc runs in if it is convex: the other if it is concave.
  int direction_if_convex;
};

// Three patches counter-clockwise, and three arcs; arc i lies between patch i and patch i + 1.
struct Corner {
  Index vertex;
  std::array<Index, 3> patch;
  std::array<Index, 3> arc;
  int chirality;  // sign of det of the three labels' directions
};

struct ArcNetwork {
  // For patches of valence 3 without opposite neighbors.
  ArcNetwork(const Surface& surface, const Patches& patches, const base::Host& host);

  std::span<const Index> half_edges_of(const Arc& arc) const { return {half_edges.data() + arc.begin, arc.size}; }

  Array<Arc> arcs;
  Array<Index> half_edges;  // of the patches on the left
  Array<Index> arc_of;      // of each half-edge of the surface, or no_index
  Array<Corner> corners;
  Array<Index> corner_of_vertex;  // or no_index
};

}  // namespace orbicube::polycube
