#include "frame_field/smoothing/active_region.h"

#include <cmath>

#include "quaternion/frame_distance.h"

namespace orbicube::frame_field {
namespace {

// An entry a node: 1 for those of the region.
Array<std::uint8_t> mark(const DualGraph& graph, const Field& field, double angle, int rings, const base::Host& host) {
  const double threshold = std::sin(0.5 * angle) * std::sin(0.5 * angle);
  Array<std::uint8_t> in(graph.size(), 0, host.memory);
  for_each_chunk(host, graph.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      bool differs = false;
      for (const Index other : graph.others[i])
        differs = differs || quaternion::symmetric_sine_square(field[i], field[other]) > threshold;
      in[i] = differs ? 1 : 0;
    }
  });
  Array<Index> front(host.memory), next(host.memory);
  for (Index i = 0; i < graph.size(); ++i) {
    if (in[i] != 0) front.push_back(i);
  }
  for (int ring = 0; ring < rings; ++ring) {
    next.clear();
    for (const Index i : front) {
      for (const Index other : graph.others[i]) {
        if (in[other] != 0) continue;
        in[other] = 1;
        next.push_back(other);
      }
    }
    std::swap(front, next);
  }
  return in;
}

}  // namespace

ActiveRegion active_region(const DualGraph& graph, const Constraints& constraints, const Field& field, double angle,
                           int rings, const base::Host& host) {
  const Array<std::uint8_t> in = mark(graph, field, angle, rings, host);
  ActiveRegion region(host.memory);
  Array<Index> number(graph.size(), no_index, host.memory);
  for (Index i = 0; i < graph.size(); ++i) {
    if (in[i] == 0) continue;
    number[i] = static_cast<Index>(region.nodes.size());
    region.nodes.push_back(i);
  }
  const std::size_t count = region.nodes.size();
  region.graph.others.resize(count);
  region.graph.weights.resize(count);
  region.outside.resize(count);
  for_each_chunk(host, count, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index node = region.nodes[i];
      for (std::size_t k = 0; k < 4; ++k) {
        const Index other = graph.others[node][k];
        const float w = graph.weights[node][k];
        const bool inside = other == node || number[other] != no_index;
        region.graph.others[i][k] = inside ? number[other] : static_cast<Index>(i);
        region.graph.weights[i][k] = inside ? w : 0;
        if (inside) continue;
        const Harmonic h = harmonic_of(field[other]);
        region.outside[i].weight += w;
        for (std::size_t m = 0; m < h.size(); ++m)
          region.outside[i].sum[m] += static_cast<double>(w) * h[m];
      }
    }
  });
  region.constraints.of_node.assign(count, no_index);
  for (Constraint c : constraints.list) {
    if (number[c.node] == no_index) continue;
    c.node = number[c.node];
    region.constraints.of_node[c.node] = static_cast<Index>(region.constraints.list.size());
    region.constraints.list.push_back(c);
  }
  for (Pull pull : constraints.pulls) {
    if (number[pull.node] == no_index) continue;
    pull.node = number[pull.node];
    region.constraints.pulls.push_back(pull);
  }
  return region;
}

}  // namespace orbicube::frame_field
