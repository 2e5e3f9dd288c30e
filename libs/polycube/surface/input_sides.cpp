#include "polycube/surface/input_sides.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace orbicube::polycube {
namespace {

Vector3 twice_area(const EditableSurface& surface, Index a, Index b, Index c) {
  const auto& p = surface.position;
  return (p[b] - p[a]).cross(p[c] - p[a]);
}

}  // namespace

InputSides::InputSides(const EditableSurface& surface, std::pmr::memory_resource* memory)
    : surface_(surface), normals_(memory) {
  // The sum over pieces is the triangle's, whichever way some are turned.
  for (Index f = 0; f < surface.faces(); ++f) {
    if (!surface.alive(f)) continue;
    const Index from = surface.triangle_source[f];
    if (from >= normals_.size()) normals_.resize(from + 1, Vector3::Zero());
    const auto& [a, b, c] = surface.triangle[f];
    normals_[from] += twice_area(surface, a, b, c);
  }
}

bool InputSides::along(Index v, Index w) const {
  const VertexSource &from = surface_.source[v], &to = surface_.source[w];
  if (from.corner[2] != no_index) return true;  // all its triangles lie in one of the input
  return std::all_of(to.corner.begin(), to.corner.end(),
                     [&](Index c) { return c == no_index || c == from.corner[0] || c == from.corner[1]; });
}

bool InputSides::up(Index face, Index a, Index b, Index c) const {
  return twice_area(surface_, a, b, c).dot(normals_[surface_.triangle_source[face]]) > 0;
}

}  // namespace orbicube::polycube
