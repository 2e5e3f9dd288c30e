#include "polycube/map/labelled_target.h"

#include <algorithm>

#include "base/error.h"
#include "polycube/labels/charts.h"

namespace orbicube::polycube {

Construction draw_labelled(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const SurfaceMap& map, const base::Host& host) {
  const Surface surface(Array<Vector3>(map.positions, host.memory), Array<Triangle>(map.triangles, host.memory), host);
  const Charts charts = find_charts(surface, map.labels, host);
  Array<Index> corner_vertices(host.memory);
  Array<Index> corner_of(map.positions.size(), no_index, host.memory);
  Array<Vector3> corners(host.memory);
  for (Index v = 0; v < map.positions.size(); ++v) {
    if (!charts.is_corner(v)) continue;
    corner_of[v] = static_cast<Index>(corners.size());
    corner_vertices.push_back(v);
    corners.push_back(map.polycube[v]);
  }
  // Of all patches one after another: the corners along their loops, and where each loop begins.
  Array<Index> around(host.memory), begins(host.memory);
  Array<std::size_t> chart_begin(host.memory), chart_loops(host.memory);
  for (std::size_t c = 0; c < charts.count(); ++c) {
    chart_begin.push_back(around.size());
    chart_loops.push_back(begins.size());
    for (std::size_t l = charts.chart_loops[c]; l < charts.chart_loops[c + 1]; ++l) {
      begins.push_back(static_cast<Index>(around.size() - chart_begin[c]));
      for (const Index h : charts.loop(l))
        if (charts.is_corner(surface.start(h))) around.push_back(Index{corner_of[surface.start(h)]});
    }
    begins.push_back(static_cast<Index>(around.size() - chart_begin[c]));
  }
  chart_begin.push_back(around.size());
  chart_loops.push_back(begins.size());
  Array<GivenPatch> patches(host.memory);
  for (std::size_t c = 0; c < charts.count(); ++c)
    patches.push_back({charts.labels[c], std::span(begins).subspan(chart_loops[c], chart_loops[c + 1] - chart_loops[c]),
                       std::span(around).subspan(chart_begin[c], chart_begin[c + 1] - chart_begin[c])});
  const TargetPolycube target = target_of_patches(corners, patches, host);

  Array<CornerPlace> places(host.memory);
  for (Index i = 0; i < target.graph.corners.size(); ++i) {
    const auto at = std::find(corners.begin(), corners.end(), target.graph.corners[i]);
    if (at == corners.end()) throw base::Error("internal", "a corner of no labels");
    const Index vertex = corner_vertices[static_cast<std::size_t>(at - corners.begin())];
    places.push_back({i, map.positions[vertex], vertex});
  }
  DrawingOptions options;
  options.places = places;
  options.model = &map;
  options.redrawings = 0;
  options.smoothing_rounds = 0;
  return construct_on(positions, triangles, target.graph, target.genus, options, host);
}

}  // namespace orbicube::polycube
