#include "polycube/layout/layout_guide.h"

namespace orbicube::polycube {

LayoutGuide straight_guide(const Layout& layout, std::pmr::memory_resource* memory) {
  LayoutGuide guide(memory);
  for (Index n = 0; n < layout.nodes.size(); ++n) {
    guide.node_position.push_back(layout.node_position(n));
    guide.node_normal.push_back(layout.nodes[n].normal);
  }
  guide.node_vertex.assign(layout.nodes.size(), no_index);
  for (Index a = 0; a < layout.arcs(); ++a) {
    Array<Vector3>& line = guide.arc.emplace_back();
    line.push_back(guide.node_position[layout.origin(2 * a)]);
    line.push_back(guide.node_position[layout.target(2 * a)]);
  }
  return guide;
}

}  // namespace orbicube::polycube
