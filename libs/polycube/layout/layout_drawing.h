// The drawing of a layout while it grows on a surface: nodes at vertices, arcs as paths along edges, and room for the
// next path between them.
#pragma once

#include "polycube/layout/tracing.h"

namespace orbicube::polycube {

class LayoutDrawing {
 public:
  LayoutDrawing(const Layout& layout, EditableSurface& surface, const base::Host& host);

  // Splits the longest edges while there are too few vertices for the nodes.
  void refine_for_nodes();
  // Puts each node at the best free vertex for its guide: nodes whose vertex is given first, then corners.
  void place_nodes(const LayoutGuide& guide);
  // Draws the path of the arc for good, and makes room beside it.
  void draw(Index arc);
  // Draws a path or takes it off again, without its ends.
  void mark(Index arc, std::span<const Index> path, bool on);
  // Splits edges and triangles at the vertices that keep paths from passing between drawn vertices.
  void unblock(std::span<const Index> vertices);

  // Sets `half_edges` to those that the path of a dart may leave its node by: between the drawn darts beside it in the
  // rotation.
  void sector(Index dart, Array<Index>& half_edges) const;
  // Returns whether a way leads from the left of a drawn path to its right without crossing what is drawn.
  bool sides_connected(std::span<const Index> path) const;

  Index vertex_of(Index node) const { return drawing_.node_vertex[node]; }
  Array<Index>& path(Index arc) { return drawing_.path[arc]; }
  bool drawn(Index arc) const { return drawn_[arc] != 0; }
  std::size_t drawn_count() const { return drawn_count_; }
  const Array<std::uint8_t>& levels() const { return level_; }
  double diagonal() const { return diagonal_; }

  // Returns the nodes and paths, without the rectangles of triangles.
  Drawing take() { return std::move(drawing_); }

 private:
  Index split_edge(Index h);
  Array<Vector3> vertex_normals() const;
  Index nearest_free_vertex(const LayoutGuide& guide, Index node, std::span<const Vector3> normals,
                            std::span<const std::uint8_t> crowded) const;

  const Layout& layout_;
  EditableSurface& surface_;
  const base::Host& host_;
  Drawing drawing_;
  Array<std::uint8_t> level_;  // of each vertex: how often edges were halved for it
  Array<std::uint8_t> drawn_;  // of each arc
  std::size_t drawn_count_ = 0;
  double diagonal_ = 0;  // of the surface's bounding box
  std::size_t max_faces_ = 0;
};

}  // namespace orbicube::polycube
