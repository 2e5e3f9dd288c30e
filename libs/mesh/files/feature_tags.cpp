#include "mesh/files/feature_tags.h"

#include "mesh/topology/weld.h"

namespace orbicube::mesh {

void renumber_as_welded(FeatureTags& tags, std::span<const Vector3> positions, const base::Host& host) {
  if (tags.empty()) return;
  Array<Index> to = first_at_same_position(positions, host);
  Index kept = 0;
  for (std::size_t v = 0; v < to.size(); ++v)
    to[v] = to[v] == v ? kept++ : to[to[v]];
  for (auto& [from, end] : tags.edges) {
    from = to[from];
    end = to[end];
  }
  std::erase_if(tags.edges, [](const auto& edge) { return edge[0] == edge[1]; });
  for (Index& v : tags.vertices)
    v = to[v];
}

}  // namespace orbicube::mesh
