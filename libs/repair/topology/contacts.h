// Edges and vertices where more than one sheet of the surface meets, split so that each sheet has its own: the cutting
// of Gueziec, Taubin, Lazarus and Horn 2001, "Cutting and stitching: converting sets of polygons to manifold surfaces",
// with the faces at an edge paired by their order around it.
#pragma once

#include "repair/types.h"

namespace orbicube::repair {

struct ContactFigures {
  std::size_t edges = 0;     // of more than two faces
  std::size_t vertices = 0;  // with more than one fan of faces
  std::size_t added_vertices = 0;
  double largest_move = 0;  // by the gap
};

// Faces at an edge of more than two are paired so that each pair bounds one wedge of the solid: solids that touch there
// are separated. An odd face out, of an open patch or else of the patch with the smallest area, keeps an open edge.
// Each fan of faces at a vertex then gets a vertex of its own; the first one keeps the number. Vertices of split places
// move by `gap` into their own sheet's inner side, so that sheets do not touch. With join_open_fans, fans of one part
// that have open edges at a vertex keep it together: between them are holes, which touch there. The faces at each edge
// of two must pass it in both directions. O(n). Throws Error "cancelled".
ContactFigures split_contacts(Soup& soup, double gap, bool join_open_fans, const Context& context);

}  // namespace orbicube::repair
