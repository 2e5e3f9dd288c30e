// A polycube map of a surface: the surface, refined where that was needed, and where each of its vertices lies on the
// polycube. What every construction makes, and what leaves the library once it is certified (certificate.h).
#pragma once

#include <array>
#include <numeric>

#include "mesh/mesh.h"
#include "polycube/surface/axis_label.h"

namespace orbicube::polycube {

using base::Array;
using mesh::Index;
using mesh::no_index;
using mesh::Triangle;
using mesh::Vector3;

// Where a vertex comes from: a convex combination of up to three vertices of one triangle of the input. A vertex of the
// input has itself as the first corner, with weight 1; corners that are not needed are no_index, with weight 0.
struct VertexSource {
  std::array<Index, 3> corner{no_index, no_index, no_index};
  std::array<double, 3> weight{};
};

struct SurfaceMap {
  explicit SurfaceMap(std::pmr::memory_resource* memory = std::pmr::get_default_resource())
      : positions(memory),
        polycube(memory),
        vertex_sources(memory),
        triangles(memory),
        labels(memory),
        patches(memory),
        triangle_sources(memory) {}

  // Of each vertex. Those of the input come first, in its order and to the bit.
  Array<Vector3> positions;  // in space
  Array<Vector3> polycube;   // on the polycube
  Array<VertexSource> vertex_sources;

  // Of each triangle. A patch is a connected set of triangles with one label: a patch of the polycube.
  Array<Triangle> triangles;
  Array<AxisLabel> labels;
  Array<Index> patches;
  Array<Index> triangle_sources;  // the input's triangle that it lies in
};

// Sources of a map that has the very vertices and triangles of its surface.
inline void set_unrefined(SurfaceMap& map) {
  map.vertex_sources.resize(map.positions.size());
  for (Index v = 0; v < map.positions.size(); ++v)
    map.vertex_sources[v] = {{v, no_index, no_index}, {1, 0, 0}};
  map.triangle_sources.resize(map.triangles.size());
  std::iota(map.triangle_sources.begin(), map.triangle_sources.end(), Index{0});
}

}  // namespace orbicube::polycube
