// The surface of a solid with its feature graph, from tags, from dihedral angles, or from both.
#pragma once

#include "hexmesh/captured/feature_figures.h"
#include "mesh/features/feature_graph.h"

namespace orbicube::hexmesh {

struct FeatureRequest {
  Features features = Features::off;
  double angle = 40;                              // in degrees; 0: no edge is sharp
  std::span<const mesh::Edge> tagged_edges = {};  // of the input
  std::span<const Index> tagged_vertices = {};
  double shortest_side = 0;  // of corners where a line only bends (mesh::FeatureOptions)
};

struct FeatureSurface {
  explicit FeatureSurface(std::pmr::memory_resource* memory)
      : positions(memory), triangles(memory), lines(memory), ends(memory), graph(memory) {}

  Array<Vector3> positions;
  Array<mesh::Triangle> triangles;  // outward-oriented
  std::size_t pieces = 0;           // of the solid
  Array<mesh::Edge> lines;          // tagged edges and vertices of it
  Array<Index> ends;
  mesh::FeatureGraph graph;
};

// Of a closed surface, or of the boundary of tetrahedra. Throws Error as volume_map::pieces_of_surface() and
// mesh::feature_graph() do.
FeatureSurface feature_surface(const mesh::Mesh& input, const FeatureRequest& request, const base::Host& host);

// The graph of a surface without some edges of its arcs, and without the arcs that would end inside a patch then.
mesh::FeatureGraph graph_without(const FeatureSurface& surface, const FeatureRequest& request,
                                 std::span<const mesh::Edge> edges, const base::Host& host);

}  // namespace orbicube::hexmesh
