#include "polycube/outputs/patch_rectangles.h"

#include <algorithm>
#include <tuple>

#include "base/error.h"

namespace orbicube::polycube {
namespace {

Index layer_at(const Array<double>& layers, double x) {
  const auto place = std::lower_bound(layers.begin(), layers.end(), x);
  if (place == layers.end() || *place != x)
    throw base::Error("invalid-argument", "a corner lies in no plane of a patch");
  return static_cast<Index>(place - layers.begin());
}

}  // namespace

std::array<Array<double>, 3> layers_of(const PatchGraph& graph, std::pmr::memory_resource* memory) {
  std::array<Array<double>, 3> layers = {Array<double>(memory), Array<double>(memory), Array<double>(memory)};
  for (Index p = 0; p < graph.patches(); ++p)
    layers[static_cast<std::size_t>(axis_of(graph.labels[p]))].push_back(graph.coordinates[p]);
  for (Array<double>& along : layers) {
    std::sort(along.begin(), along.end());
    along.erase(std::unique(along.begin(), along.end()), along.end());
  }
  return layers;
}

Array<PatchRectangle> rectangles_of(const PatchGraph& graph, const std::array<Array<double>, 3>& layers,
                                    const base::Host& host) {
  Array<PatchRectangle> result(host.memory);
  Array<int> change(host.memory);
  for (Index p = 0; p < graph.patches(); ++p) {
    host.report("patches", 0, 0);
    const AxisLabel label = graph.labels[p];
    const std::size_t u = first_axis(label), v = second_axis(label);
    const Index plane = layer_at(layers[static_cast<std::size_t>(axis_of(label))], graph.coordinates[p]);
    const std::size_t columns = layers[u].size(), rows = layers[v].size() - 1;
    // By how much the winding number of the loops changes at each layer along u, in each row between layers along v.
    change.assign(columns * rows, 0);
    for (Index l = graph.loops_of_patch[p]; l < graph.loops_of_patch[p + 1]; ++l) {
      for (const Index dart : graph.loop(l)) {
        const Vector3 &a = graph.corners[graph.origin(dart)], &b = graph.corners[graph.target(dart)];
        const auto at = [&](const Vector3& corner, std::size_t axis) {
          return layer_at(layers[axis], corner[static_cast<Eigen::Index>(axis)]);
        };
        const Index from = at(a, v), to = at(b, v), column = at(a, u);
        // The patch is on the left of its edges.
        for (Index row = std::min(from, to); row < std::max(from, to); ++row)
          change[row * columns + column] += (from > to ? 1 : -1) * sign_of(label);
      }
    }
    for (Index row = 0; row < rows; ++row) {
      int winding = 0;
      for (Index column = 0; column + 1 < columns; ++column) {
        winding += change[row * columns + column];
        if (winding == 1) result.push_back({label, plane, column, row, p});
      }
    }
  }
  std::sort(result.begin(), result.end(), [](const PatchRectangle& a, const PatchRectangle& b) {
    return std::tie(a.label, a.plane, a.second, a.first) < std::tie(b.label, b.plane, b.second, b.first);
  });
  return result;
}

}  // namespace orbicube::polycube
