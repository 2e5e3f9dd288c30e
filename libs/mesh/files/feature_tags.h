// Edges and vertices that a file marks beside its faces and cells, such as the curves of a CAD model.
#pragma once

#include <span>
#include <vector>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

struct FeatureTags {
  std::vector<std::array<Index, 2>> edges;
  std::vector<Index> vertices;

  bool empty() const { return edges.empty() && vertices.empty(); }
  // Adds the edges along a line of vertices.
  void add_line(std::span<const Index> line) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (line[i - 1] != line[i]) edges.push_back({line[i - 1], line[i]});
    }
  }
};

// Gives the tags the numbers that weld() gives the vertices at these positions. O(n).
void renumber_as_welded(FeatureTags& tags, std::span<const Vector3> positions, const base::Host& host);

}  // namespace orbicube::mesh
