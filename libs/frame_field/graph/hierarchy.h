// Coarser and coarser graphs over the dual graph: groups of up to eight linked nodes become one node, the links between
// groups add up. What multigrid (graph_solver.h) solves long waves on.
#pragma once

#include <span>

#include "base/host.h"
#include "frame_field/graph/dual_graph.h"

namespace orbicube::frame_field {

struct CoarseGraph {
  explicit CoarseGraph(std::pmr::memory_resource* memory)
      : group(memory), begin(memory), other(memory), weight(memory), total_weight(memory), members(memory) {}

  std::size_t size() const { return members.size(); }

  Array<Index> group;         // by node of the finer graph: the node of this one
  Array<Index> begin;         // of the links of each node, size() + 1 entries
  Array<Index> other;         // by link, each of which is there from both ends
  Array<float> weight;        // by link
  Array<float> total_weight;  // by node
  Array<float> members;       // nodes of the finest graph
};

// Levels down to at most `smallest` nodes, or to where grouping gains nothing. O(n).
Array<CoarseGraph> make_hierarchy(const DualGraph& graph, std::size_t smallest, const base::Host& host);

}  // namespace orbicube::frame_field
