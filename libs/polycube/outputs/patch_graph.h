// A polycube without its triangles: corners, straight edges between them, patches (its faces) with the loops of edges
// around them, and the dual graph, which has a node a patch and a link an edge.
#pragma once

#include <span>

#include "base/host.h"
#include "polycube/surface/surface_map.h"

namespace orbicube::polycube {

// Edge e has two darts: 2 e from its first corner to its second, 2 e + 1 back.
struct PatchGraph {
  explicit PatchGraph(std::pmr::memory_resource* memory)
      : corners(memory),
        corner_vertices(memory),
        dart_origin(memory),
        dart_left(memory),
        convex(memory),
        path_begin(memory),
        paths(memory),
        labels(memory),
        coordinates(memory),
        loops_of_patch(memory),
        loop_begin(memory),
        loops(memory),
        neighbor_begin(memory),
        neighbors(memory) {}

  std::size_t edges() const { return convex.size(); }
  std::size_t patches() const { return labels.size(); }
  Index origin(Index dart) const { return dart_origin[dart]; }
  Index target(Index dart) const { return dart_origin[dart ^ 1U]; }
  // Vertices of the map along an edge, corners included.
  std::span<const Index> path(Index edge) const {
    return {paths.data() + path_begin[edge], path_begin[edge + 1] - path_begin[edge]};
  }
  // Darts of a loop, counter-clockwise around the patch on their left, seen from outside.
  std::span<const Index> loop(Index number) const {
    return {loops.data() + loop_begin[number], loop_begin[number + 1] - loop_begin[number]};
  }
  // Patches that share an edge with a patch, ascending, each once.
  std::span<const Index> neighbors_of(Index patch) const {
    return {neighbors.data() + neighbor_begin[patch], neighbor_begin[patch + 1] - neighbor_begin[patch]};
  }

  Array<Vector3> corners;
  Array<Index> corner_vertices;  // of the map
  Array<Index> dart_origin;      // corner that a dart starts at
  Array<Index> dart_left;        // patch on its left
  Array<std::uint8_t> convex;    // of each edge: the solid has a right angle there; else three
  Array<Index> path_begin, paths;
  Array<AxisLabel> labels;         // the direction that each patch looks in
  Array<double> coordinates;       // of its plane along that axis
  Array<Index> loops_of_patch;     // loops [loops_of_patch[p], loops_of_patch[p + 1]): the outer one, then holes
  Array<Index> loop_begin, loops;  // darts
  Array<Index> neighbor_begin, neighbors;  // the dual graph
};

// Of a certified map. Patches have the numbers of its patches. O(n log n). Throws Error "invalid-argument" for a map
// that cannot be certified, "cancelled".
PatchGraph make_patch_graph(const SurfaceMap& map, const base::Host& host);

}  // namespace orbicube::polycube
