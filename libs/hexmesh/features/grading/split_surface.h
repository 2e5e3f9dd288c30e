// A surface with a feature graph whose long edges are split: the same surface, with vertices close enough to each other
// for a map that is not linear.
#pragma once

#include <functional>

#include "hexmesh/types.h"
#include "mesh/features/feature_graph.h"

namespace orbicube::hexmesh {

// A copy; corners and patches keep their numbers.
struct SplitSurface {
  SplitSurface(std::span<const Vector3> p, std::span<const mesh::Triangle> t, const mesh::FeatureGraph& g,
               std::pmr::memory_resource* memory)
      : positions(p.begin(), p.end(), memory), triangles(t.begin(), t.end(), memory), graph(memory) {
    graph = g;
  }

  Array<Vector3> positions;
  Array<mesh::Triangle> triangles;
  mesh::FeatureGraph graph;
};

// Splits edges in the middle, with the triangles beside them, while `too_long(from, to)` is true for some, in at most
// ten rounds.
void split_edges(SplitSurface& surface, const std::function<bool(const Vector3&, const Vector3&)>& too_long,
                 const base::Host& host);

}  // namespace orbicube::hexmesh
