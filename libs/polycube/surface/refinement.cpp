#include "polycube/surface/refinement.h"

#include <algorithm>

#include "base/error.h"
#include "mesh/topology/connectivity.h"

namespace orbicube::polycube {
namespace {

// The middle of two points that lie in one triangle of the input, given by its corners and weights.
VertexSource middle(const VertexSource& a, const VertexSource& b) {
  VertexSource result;
  std::size_t size = 0;
  for (const VertexSource& source : {a, b}) {
    for (std::size_t i = 0; i < 3 && source.corner[i] != no_index; ++i) {
      const auto* const end = result.corner.begin() + size;
      const auto place =
          static_cast<std::size_t>(std::find(result.corner.cbegin(), end, source.corner[i]) - result.corner.cbegin());
      if (place == 3) throw base::Error("internal", "an edge that lies in no triangle of the input");
      if (place == size) result.corner[size++] = source.corner[i];
      result.weight[place] += 0.5 * source.weight[i];
    }
  }
  return result;
}

}  // namespace

SurfaceMap unrefined(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                     std::span<const AxisLabel> labels, const base::Host& host) {
  SurfaceMap map(host.memory);
  map.positions.assign(positions.begin(), positions.end());
  map.triangles.assign(triangles.begin(), triangles.end());
  map.labels.assign(labels.begin(), labels.end());
  set_unrefined(map);
  return map;
}

void split_chords(SurfaceMap& map, const base::Host& host) {
  Array<std::uint8_t> on_boundary(host.memory), changed(host.memory);
  Array<Triangle> before(host.memory);
  for (;;) {
    before = map.triangles;
    const mesh::Connectivity connectivity(map.positions.size(), before, host);
    const auto count = static_cast<Index>(before.size());
    const auto separates = [&](Index h) { return map.labels[h / 3] != map.labels[connectivity.opposite(h) / 3]; };
    on_boundary.assign(map.positions.size(), 0);
    for (Index h = 0; h < 3 * count; ++h) {
      if (separates(h)) on_boundary[connectivity.start(h)] = 1;
    }
    changed.assign(count, 0);
    bool any = false;
    for (Index h = 0; h < 3 * count; ++h) {
      const Index g = connectivity.opposite(h);
      const Index t = h / 3, s = g / 3;
      if (h > g || separates(h) || changed[t] || changed[s]) continue;
      const Index a = connectivity.start(h), b = connectivity.end(h);
      if (!on_boundary[a] || !on_boundary[b]) continue;
      const Index c = connectivity.start(mesh::Connectivity::previous(h));
      const Index d = connectivity.start(mesh::Connectivity::previous(g));
      const auto m = static_cast<Index>(map.positions.size());
      map.positions.push_back(0.5 * (map.positions[a] + map.positions[b]));
      map.vertex_sources.push_back(middle(map.vertex_sources[a], map.vertex_sources[b]));
      map.triangles[t] = {a, m, c};
      map.triangles[s] = {b, m, d};
      const auto add = [&](const Triangle& triangle, Index of) {
        map.triangles.push_back(triangle);
        map.labels.push_back(AxisLabel{map.labels[of]});
        map.triangle_sources.push_back(Index{map.triangle_sources[of]});
      };
      add({m, b, c}, t);
      add({m, a, d}, s);
      changed[t] = changed[s] = 1;
      any = true;
    }
    if (!any) return;
  }
}

}  // namespace orbicube::polycube
