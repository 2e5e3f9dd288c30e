// Sharp edges of a surface, and the edges of its polycube that they should be mapped to.
#pragma once

#include "polycube/outputs/patch_graph.h"

namespace orbicube::polycube {

// Vertices on sharp edges and where they belong: on the line of an edge of the polycube, or, where sharp edges for two
// of its edges meet, at the corner between these.
struct SharpVertex {
  Index vertex;
  Index edge;    // of the graph
  Index corner;  // of the graph, or no_index
};

struct SharpEdges {
  explicit SharpEdges(std::pmr::memory_resource* memory) : edges(memory), vertices(memory) {}

  // Of the map, two vertices each, at which its surface bends by the angle or more.
  Array<std::array<Index, 2>> edges;
  Array<SharpVertex> vertices;  // those that belong somewhere
  double length = 0;            // of the edges, on the surface
};

// An edge belongs to the nearest edge of the polycube that runs along it and bends the same way, unless that is farther
// away than a part of the polycube.
SharpEdges find_sharp_edges(const SurfaceMap& map, const PatchGraph& graph, double degrees, const base::Host& host);

// The length of those that lie on edges of the polycube, whatever these are.
double length_on_edges(const SurfaceMap& map, double degrees, const base::Host& host);

}  // namespace orbicube::polycube
