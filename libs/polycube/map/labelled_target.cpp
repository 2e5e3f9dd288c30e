#include "polycube/map/labelled_target.h"

#include <algorithm>

#include "base/error.h"
#include "polycube/labels/patches.h"

namespace orbicube::polycube {

Construction draw_labelled(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                           const SurfaceMap& map, const base::Host& host) {
  const Surface surface(Array<Vector3>(map.positions, host.memory), Array<Triangle>(map.triangles, host.memory), host);
  const Patches patches = find_patches(surface, map.labels, host);
  Array<Index> corner_vertices(host.memory);
  Array<Index> corner_of(map.positions.size(), no_index, host.memory);
  Array<Vector3> corners(host.memory);
  for (Index v = 0; v < map.positions.size(); ++v) {
    if (!patches.is_corner(v)) continue;
    corner_of[v] = static_cast<Index>(corners.size());
    corner_vertices.push_back(v);
    corners.push_back(map.polycube[v]);
  }
  // Of all patches one after another: the corners along their loops, and where each loop begins.
  Array<Index> around(host.memory), begins(host.memory);
  Array<std::size_t> patch_begin(host.memory), patch_loops(host.memory);
  for (std::size_t c = 0; c < patches.count(); ++c) {
    patch_begin.push_back(around.size());
    patch_loops.push_back(begins.size());
    for (std::size_t l = patches.patch_loops[c]; l < patches.patch_loops[c + 1]; ++l) {
      begins.push_back(static_cast<Index>(around.size() - patch_begin[c]));
      for (const Index h : patches.loop(l))
        if (patches.is_corner(surface.start(h))) around.push_back(Index{corner_of[surface.start(h)]});
    }
    begins.push_back(static_cast<Index>(around.size() - patch_begin[c]));
  }
  patch_begin.push_back(around.size());
  patch_loops.push_back(begins.size());
  Array<GivenPatch> given(host.memory);
  for (std::size_t c = 0; c < patches.count(); ++c)
    given.push_back({patches.labels[c], std::span(begins).subspan(patch_loops[c], patch_loops[c + 1] - patch_loops[c]),
                     std::span(around).subspan(patch_begin[c], patch_begin[c + 1] - patch_begin[c])});
  const TargetPolycube target = target_of_patches(corners, given, host);

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
