#include "polycube/dissertation/printed_construction.h"
#include "polycube/layout/given_polycube.h"
#include "polycube/layout/layout.h"
#include "polycube/outputs/patch_graph.h"

namespace orbicube::polycube::dissertation {

std::size_t count_corner_points(const SurfaceMap& map, const base::Host& host) {
  return make_layout(solid_of(make_patch_graph(map, host), host), host).nodes.size();
}

}  // namespace orbicube::polycube::dissertation
