#include "frame_field/singularities/meshability.h"

#include <algorithm>
#include <array>
#include <utility>

namespace orbicube::frame_field {

bool is_vertex_of_hexahedra(std::size_t edges_of_three, std::size_t edges_of_five) {
  // The regular vertex, curves of three and of five that pass through, and the eight nodes.
  constexpr std::array<std::pair<std::size_t, std::size_t>, 11> spheres = {
      {{0, 0}, {2, 0}, {0, 2}, {4, 0}, {2, 2}, {1, 3}, {0, 4}, {2, 6}, {0, 6}, {0, 8}, {0, 12}}};
  return std::ranges::find(spheres, std::pair(edges_of_three, edges_of_five)) != spheres.end();
}

Meshability meshability(const SingularGraph& graph, std::span<const std::uint8_t> boundary_vertices,
                        std::pmr::memory_resource* memory) {
  Meshability result(memory);
  struct End {
    Index vertex;
    std::int8_t turn;
  };
  Array<End> ends(memory);
  for (Index e = 0; e < graph.edges.size(); ++e) {
    const SingularEdge& edge = graph.edges[e];
    if (edge.turn != 1 && edge.turn != -1) result.edges.push_back(e);
    for (const Index v : edge.vertices) {
      if (boundary_vertices[v] == 0) ends.push_back({v, edge.turn});
    }
  }
  std::ranges::sort(ends, {}, &End::vertex);
  for (std::size_t i = 0; i < ends.size();) {
    const Index vertex = ends[i].vertex;
    std::size_t of_three = 0, of_five = 0, others = 0, count = 0;
    for (; i < ends.size() && ends[i].vertex == vertex; ++i, ++count)
      ++(ends[i].turn == 1 ? of_three : ends[i].turn == -1 ? of_five : others);
    // With an improper edge, what is wrong is the edge; where one passes through there is nothing more to tell.
    const bool proper = others == 0 ? is_vertex_of_hexahedra(of_three, of_five) : count == 2 && others == 2;
    if (proper) continue;
    result.vertices.push_back(vertex);
    ++(count == 2 ? result.turning_points : result.improper_nodes);
  }
  return result;
}

}  // namespace orbicube::frame_field
