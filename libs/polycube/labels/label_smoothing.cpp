#include "polycube/labels/label_smoothing.h"

#include <array>

namespace orbicube::polycube {
namespace {

// Whether the triangle may change from its label to `to`.
bool may_change(const Surface& surface, std::span<const AxisLabel> labels, Index triangle, AxisLabel to) {
  std::array<AxisLabel, 4> runs{};  // labels around the triangle, each once for each run
  std::size_t count = 0;
  bool own_across_an_edge = false;
  for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
    own_across_an_edge = own_across_an_edge || labels[surface.neighbor(h)] == labels[triangle];
    for (Index g = surface.turned(h); g != h; g = surface.turned(g)) {
      const AxisLabel label = labels[g / 3];
      if (count > 0 && runs[count - 1] == label) continue;
      if (count == runs.size()) return false;
      runs[count++] = label;
    }
  }
  if (count > 1 && runs[0] == runs[count - 1]) --count;
  if (!own_across_an_edge || count < 2 || count > 3) return false;
  bool has_own = false, has_other = false;
  for (std::size_t i = 0; i < count; ++i) {
    has_own = has_own || runs[i] == labels[triangle];
    has_other = has_other || runs[i] == to;
    for (std::size_t j = 0; j < i; ++j) {
      if (runs[i] == runs[j]) return false;
    }
  }
  return has_own && has_other;
}

}  // namespace

void smooth_labels(const Surface& surface, const LabelCosts& costs, int sweeps, std::span<AxisLabel> labels,
                   const base::Host& host) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    bool changed = false;
    for (Index t = 0; t < labels.size(); ++t) {
      if (t % 8192 == 0) host.report("labels", 0, 0);
      const auto cost_of = [&](AxisLabel label) {
        double cost = costs.data[t][label];
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
          cost += costs.boundary[h] * label_distance(label, labels[surface.neighbor(h)]);
        return cost;
      };
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        const AxisLabel to = labels[surface.neighbor(h)];
        if (to == labels[t] || !(cost_of(to) < cost_of(labels[t]) - 1e-15)) continue;
        if (!may_change(surface, labels, t, to)) continue;
        labels[t] = to;
        changed = true;
      }
    }
    if (!changed) return;
  }
}

}  // namespace orbicube::polycube
