// Whether a field is that of a hexahedral mesh around every edge and vertex, which smoothness alone does not give (Liu
// and Bommes 2023, "Locally meshable frame fields"), and where it is not.
#pragma once

#include <cstddef>
#include <span>

#include "frame_field/singularities/singularities.h"

namespace orbicube::frame_field {

struct Meshability {
  explicit Meshability(std::pmr::memory_resource* memory) : edges(memory), vertices(memory) {}

  bool locally_meshable() const { return edges.empty() && vertices.empty(); }

  // Singular edges (numbers in the graph) around which no three or five cells meet: third turns and half turns about
  // diagonals have no axis of the frame along the edge; half turns about an axis would need two cells or six.
  Array<Index> edges;
  // Inner vertices whose edges of three and of five cells are those of no hexahedral mesh: turning points, where one
  // changes into the other, and nodes.
  Array<Index> vertices;
  std::size_t turning_points = 0, improper_nodes = 0;
};

// Around an inner vertex of a hexahedral mesh the cells are the triangles of a sphere whose corners are the edges: with
// three to five cells an edge there are ten such spheres with a singular edge (Liu, Zhang, Chien, Solomon, Bommes 2018,
// "Singularity-constrained octahedral fields for hexahedral meshing"), distinguished by their numbers of edges of three
// and of five cells. True for these numbers, and for (0, 0).
bool is_vertex_of_hexahedra(std::size_t edges_of_three, std::size_t edges_of_five);

// O(singular edges log singular edges).
Meshability meshability(const SingularGraph& graph, std::span<const std::uint8_t> boundary_vertices,
                        std::pmr::memory_resource* memory);

}  // namespace orbicube::frame_field
