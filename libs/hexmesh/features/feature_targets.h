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

  // Of a mesh whose quads have their patches. Keeps references to the shape and to the quads.
  FeatureTargets(const HexMesh& mesh, const FeatureShape& shape, const Embedding& embedding, const base::Host& host);

  // The same targets on another shape of the same graph, to which a reference is kept from now on. Pulls of a vertex
  // are divided by the square of `size`, that of the cells there.
  void move_to(const FeatureShape& shape, std::span<const double> size);

  Kind kind(Index v) const { return kind_[v]; }
  std::span<const Index> vertices() const { return vertices_; }  // of the boundary, ascending

  // Takes the directions in which the boundary looks at its vertices, before the targets of these.
  void look_from(std::span<const Vector3> positions);

  // The target of a vertex that is at p now, and the normal of the patch or the tangent of the arc there.
  struct Target {
    Vector3 position, direction;
  };
  Target target(Index v, const Vector3& p) const;

  // Gives a vertex of a patch a place there, from now on.
  void keep_at(Index v, const Vector3& place);
  bool is_kept(Index v) const { return kept_[v] != 0; }
  void release(Index v) { kept_[v] = 0; }
  Index patch(Index v) const { return owner_[v]; }  // of a vertex of a patch

  // What pulls of a vertex are multiplied by.
  double weight(Index v) const { return pull_[v]; }
  // Adds what pulls a vertex at p to its target. Vertices of arcs slide along them where `slide` is true.
  void pull(Index v, const Vector3& p, double weight, bool slide, Pull& pull) const;

  // Moves the targets of the vertices of each arc to the points nearest to them, in their order and not too close to
  // each other. Where a sharp line bends or fades, one stays there if the others leave room.
  void slide(std::span<const Vector3> positions);

  // The arc length at which a vertex of an arc is, and where it may be between its neighbors.
  double place(Index v) const { return s_[v]; }
  void set_place(Index v, double s) { s_[v] = s; }
  double clamped_place(Index v, double s) const;
  Index arc(Index v) const { return owner_[v]; }
  const FeatureShape& shape() const { return *shape_; }

 private:
  void keep_near_fades(Index arc);
  void space_out(Index arc);
  void pull_to_target(Index v, const Vector3& p, double weight, bool slide, Pull& pull) const;

  const FeatureShape* shape_;
  Array<Kind> kind_;
  Array<Index> owner_;        // corner, arc or patch
  Array<Index> along_;        // place of a vertex in the path of its arc
  Array<double> s_;           // arc length
  Array<std::uint8_t> kept_;  // whether a vertex of an arc stays at its arc length, or one of a patch at its place
  Array<Vector3> places_;     // those of vertices of patches
  Array<Array<Index>> paths_;
  Array<Array<double>> spacing_;  // of each arc, the lengths that its edges have where all are alike in cells
  Array<double> pull_;            // of each vertex: times the weight
  Array<Index> vertices_;
  std::span<const Quad> quads_;
  Array<Vector3> facing_;  // of each vertex, a unit vector
};

}  // namespace orbicube::hexmesh
