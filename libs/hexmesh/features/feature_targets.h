// Where the vertices of a boundary with an embedded feature graph belong: at their corner, on their arc, on their
// patch.
#pragma once

#include "hexmesh/features/embedding.h"
#include "untangle/tetrahedra/foldover_energy.h"

namespace orbicube::hexmesh {

using untangle::Pull;

class FeatureTargets {
 public:
  enum class Kind : std::uint8_t { inside, corner, arc, patch };

  // Of a mesh whose quads have their patches. Keeps a reference to the shape.
  FeatureTargets(const HexMesh& mesh, const FeatureShape& shape, const Embedding& embedding, const base::Host& host);

  Kind kind(Index v) const { return kind_[v]; }
  std::span<const Index> vertices() const { return vertices_; }  // of the boundary, ascending

  // The target of a vertex that is at p now, and the normal of the patch or the tangent of the arc there.
  struct Target {
    Vector3 position, direction;
  };
  Target target(Index v, const Vector3& p) const;

  // Adds what pulls a vertex at p to its target. Vertices of arcs slide along them where `slide` is true.
  void pull(Index v, const Vector3& p, double weight, bool slide, Pull& pull) const;

  // Moves the targets of the vertices of each arc to the points nearest to them, in their order and not too close to
  // each other.
  void slide(std::span<const Vector3> positions);

  // The arc length at which a vertex of an arc is, and where it may be between its neighbors.
  double place(Index v) const { return s_[v]; }
  void set_place(Index v, double s) { s_[v] = s; }
  double clamped_place(Index v, double s) const;
  Index arc(Index v) const { return owner_[v]; }
  const FeatureShape& shape() const { return shape_; }

 private:
  const FeatureShape& shape_;
  Array<Kind> kind_;
  Array<Index> owner_;  // corner, arc or patch
  Array<Index> along_;  // place of a vertex in the path of its arc
  Array<double> s_;     // arc length
  Array<Array<Index>> paths_;
  Array<Index> vertices_;
};

}  // namespace orbicube::hexmesh
