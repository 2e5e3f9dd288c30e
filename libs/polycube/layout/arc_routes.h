// Paths for the arcs of a layout beside what is drawn: the cheapest along their guides, and where it has to be such
// that the rest of the surface stays connected.
#pragma once

#include "polycube/layout/layout_drawing.h"
#include "polycube/layout/path_search.h"

namespace orbicube::polycube {

class ArcRoutes {
 public:
  // May split edges of the surface where a path has to pass a vertex twice.
  ArcRoutes(const Layout& layout, const LayoutGuide& guide, EditableSurface& surface, LayoutDrawing& drawing,
            const base::Host& host);

  // Sets the drawing's path of the arc, which it does not draw, and returns its cost. The path of a generator leaves
  // its sides connected; throws Error "no-valid-result" where none is found.
  double find(Index arc, bool generator);

 private:
  auto guided_cost(Index arc) const;
  void set_sectors(Index arc);
  Index first_vertex(Index arc) const { return drawing_.vertex_of(layout_.origin(2 * arc)); }
  Index last_vertex(Index arc) const { return drawing_.vertex_of(layout_.target(2 * arc)); }
  double find_generator(Index arc, Array<Index>& path);
  bool open_loop(Index arc, std::span<const Index> twice, Array<Index>& path);
  std::size_t first_repeated(std::span<const Index> path) const;
  bool leaves_sides_connected(Index arc, std::span<const Index> path);

  const Layout& layout_;
  const LayoutGuide& guide_;
  EditableSurface& surface_;
  LayoutDrawing& drawing_;
  const base::Host& host_;
  PathSearch search_;
  Array<Index> starts_, ends_;  // half-edges that the path of an arc may leave its nodes by
};

}  // namespace orbicube::polycube
