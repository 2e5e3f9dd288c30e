#include "polycube/labels/patch_order.h"

#include <algorithm>

namespace orbicube::polycube {
namespace {

// Of the three patches at an end of an arc the one across it.
Index patch_at_end(const Arc& arc, const Corner& corner) {
  for (const Index c : corner.patch)
    if (c != arc.left && c != arc.right) return c;
  return no_index;
}

}  // namespace

Array<Index> arcs_without_order(const Patches& patches, const ArcNetwork& network, const ArcSigns& signs,
                                const base::Host& host) {
  struct Step {
    Index arc, from, to;
  };
  Array<Step> left(host.memory);
  for (Index a = 0; a < network.arcs.size(); ++a) {
    const Arc& arc = network.arcs[a];
    const Index first = network.corner_of_vertex[arc.first], last = network.corner_of_vertex[arc.last];
    if (first == no_index || last == no_index) continue;
    Step step{a, patch_at_end(arc, network.corners[first]), patch_at_end(arc, network.corners[last])};
    if (step.from == no_index || step.to == no_index) continue;
    if (arc.direction_if_convex * (signs.convex[a] ? 1 : -1) < 0) std::swap(step.from, step.to);
    left.push_back(step);
  }
  // What starts where nothing ends, or ends where nothing starts, is on no cycle.
  Array<std::uint8_t> starts(patches.count(), 0, host.memory), ends(patches.count(), 0, host.memory);
  for (std::size_t before = left.size() + 1; left.size() < before;) {
    before = left.size();
    std::fill(starts.begin(), starts.end(), std::uint8_t{0});
    std::fill(ends.begin(), ends.end(), std::uint8_t{0});
    for (const Step& s : left)
      starts[s.from] = ends[s.to] = 1;
    left.erase(std::remove_if(left.begin(), left.end(), [&](const Step& s) { return !ends[s.from] || !starts[s.to]; }),
               left.end());
  }
  Array<Index> result(host.memory);
  for (const Step& s : left)
    result.push_back(Index{s.arc});
  return result;
}

}  // namespace orbicube::polycube
