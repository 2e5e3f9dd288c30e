// The part of a graph in which short diffusions change a field by more than smoothing does: the nodes around singular
// curves and other places where neighbors differ. Everywhere else the field stays, and acts on the part like fixed
// frames.
#pragma once

#include "frame_field/graph/constraints.h"
#include "frame_field/graph/dual_graph.h"
#include "frame_field/smoothing/harmonic_frame.h"

namespace orbicube::frame_field {

// What links from a node to fixed ones add up to.
struct OutsideLinks {
  float weight = 0;
  Harmonic sum{};  // of weight times the harmonics of the fixed frame
};

struct ActiveRegion {
  explicit ActiveRegion(std::pmr::memory_resource* memory)
      : nodes(memory), graph(memory), constraints(memory), outside(memory) {}

  Array<Index> nodes;  // of the whole graph, ascending
  DualGraph graph;     // their own, without the links to other nodes
  Constraints constraints;
  Array<OutsideLinks> outside;  // by node of `graph`
};

// Returns the nodes with a neighbor at a distance of more than `angle` (radians), and those at most `rings` links from
// them. O(n).
ActiveRegion active_region(const DualGraph& graph, const Constraints& constraints, const Field& field, double angle,
                           int rings, const base::Host& host);

}  // namespace orbicube::frame_field
