// Whether vertices that were added to a surface may be merged into neighbors as far as the surface in space is
// concerned: the pieces of each triangle of the input must go on to cover it once.
#pragma once

#include "polycube/surface/editable_surface.h"

namespace orbicube::polycube {

class InputSides {
 public:
  // Refers to the surface. Its pieces cover the triangles of the input; later splits and collapses keep that.
  InputSides(const EditableSurface& surface, std::pmr::memory_resource* memory);

  // Whether the edge from v to w lies where v does: on an edge of the input, or within a triangle.
  bool along(Index v, Index w) const;

  // Whether the piece `face`, with the corners `a`, `b` and `c` in place of its own, has its side up. Compared with the
  // triangle of the input: pieces of nearly no area are turned by rounding.
  bool up(Index face, Index a, Index b, Index c) const;

 private:
  const EditableSurface& surface_;
  Array<Vector3> normals_;  // of each triangle of the input, twice its area long
};

}  // namespace orbicube::polycube
