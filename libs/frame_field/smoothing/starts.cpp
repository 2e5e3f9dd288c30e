#include "frame_field/smoothing/starts.h"

namespace orbicube::frame_field {

Field constant_start(const DualGraph& graph, const Constraints& constraints, const Quaternion& axes,
                     const base::Host& host) {
  Field field(graph.size(), axes, host.memory);
  satisfy(constraints, field);
  return field;
}

Field propagated_start(const DualGraph& graph, const Constraints& constraints, const Quaternion& axes,
                       const base::Host& host) {
  Field field = constant_start(graph, constraints, axes, host);
  Array<std::uint8_t> reached(graph.size(), 0, host.memory);
  Array<Index> front(host.memory);
  front.reserve(graph.size());
  for (const Constraint& c : constraints.list) {
    reached[c.node] = 1;
    front.push_back(c.node);
  }
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (i % 16384 == 0) host.report("propagating", i, graph.size());
    for (const Index other : graph.others[front[i]]) {
      if (reached[other] != 0) continue;
      reached[other] = 1;
      field[other] = field[front[i]];
      front.push_back(other);
    }
  }
  return field;
}

}  // namespace orbicube::frame_field
