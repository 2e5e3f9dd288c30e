#include "frame_field/smoothing/recombination.h"

#include <cmath>

#include "quaternion/frame_distance.h"

namespace orbicube::frame_field {

double take_better_regions(const DualGraph& graph, const Constraints& constraints, const Field& other, double angle,
                           const base::Host& host, Field& field) {
  const double threshold = std::sin(0.5 * angle) * std::sin(0.5 * angle);
  constexpr std::uint8_t same = 0, different = 1, in_region = 2, done = 3;
  Array<std::uint8_t> state(graph.size(), same, host.memory);
  for_each_chunk(host, graph.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i)
      state[i] = quaternion::symmetric_sine_square(field[i], other[i]) > threshold ? different : same;
  });
  Array<Index> region(host.memory);
  double gain = 0;
  for (Index start = 0; start < graph.size(); ++start) {
    if (start % 16384 == 0) host.report("recombining", start, graph.size());
    if (state[start] != different) continue;
    region.assign(1, start);
    state[start] = in_region;
    for (std::size_t r = 0; r < region.size(); ++r) {
      for (const Index next : graph.others[region[r]]) {
        if (state[next] != different) continue;
        state[next] = in_region;
        region.push_back(next);
      }
    }
    double change = 0;
    for (const Index node : region) {
      if (!constraints.pulls.empty()) {
        for (const Pull& pull : constraints.pulls_at(node))
          change += worth(pull, other[node]) - worth(pull, field[node]);
      }
      for (std::size_t k = 0; k < 4; ++k) {
        const Index next = graph.others[node][k];
        const bool inside = state[next] == in_region;
        if (inside && next <= node) continue;  // counted from its other end, or no link
        const Quaternion& beyond = inside ? other[next] : field[next];
        change +=
            static_cast<double>(graph.weights[node][k]) * (quaternion::symmetric_sine_square(other[node], beyond) -
                                                           quaternion::symmetric_sine_square(field[node], field[next]));
      }
    }
    for (const Index node : region) {
      state[node] = done;
      if (change < 0) field[node] = other[node];
    }
    if (change < 0) gain -= change;
  }
  return gain;
}

}  // namespace orbicube::frame_field
