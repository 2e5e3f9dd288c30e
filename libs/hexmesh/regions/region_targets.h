// Where the vertices of a mesh belong whose hexahedra have the labels of regions.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/grouping.h"
#include "hexmesh/regions/boundary_lines.h"
#include "hexmesh/regions/region_interfaces.h"
#include "untangle/tetrahedra/foldover_energy.h"

namespace orbicube::hexmesh {

using untangle::Pull;

class RegionTargets {
 public:
  // Vertices inside belong nowhere, fixed ones where they are: at corners of the boundary.
  enum class Kind : std::uint8_t { inside, fixed, surface, line, interface };

  // Of a mesh with edges of about length 1 and sheets between the labels. With `creases`, vertices at which faces
  // between labels bend beside a sharp edge within the faces of their regions belong on it, and those nearest to its
  // corners, or to those of curves, there. Keeps references to all but the sheets.
  RegionTargets(const HexMesh& mesh, const Array<Index>& labels, const base::Groups<Index, Index>& around,
                const Sheets& sheets, const BoundaryLines& lines, RegionInterfaces& interfaces, bool creases,
                const base::Host& host);

  Kind kind(Index v) const { return vertices_[v].kind; }
  bool on_boundary(Index v) const { return !vertices_[v].labels.empty() && vertices_[v].labels[0] == 0; }

  struct Target {
    Vector3 position, direction;  // normal of a face, or tangent of a curve
    int dimension;                // 2: of a face, 1: of a curve, 0: of a point
  };
  // Of a vertex where it is now.
  Target target(Index v);
  // Adds what pulls it there.
  void add_pull(Index v, double weight, Pull& pull);

 private:
  struct Vertex {
    Kind kind = Kind::inside;
    LabelSet labels;  // of the hexahedra around, 0 on the boundary
    std::pair<Index, Index> patches = {no_index, no_index};
    std::optional<Vector3> point;  // where it belongs
    bool on_crease = false;
  };

  void classify(const base::Groups<Index, Index>& around);
  void classify_on_boundary(Index v);
  void take_creases();
  void take_corners();
  std::optional<Vector3> point_of(Index v);
  Vector3 facing(Index v) const;

  const HexMesh& mesh_;
  const Array<Index>& labels_;
  const BoundaryLines& lines_;
  RegionInterfaces& interfaces_;
  const base::Host& host_;
  const BoundaryQuads quads_;
  const Array<Index> patch_of_quad_;
  std::vector<Vertex> vertices_;
};

}  // namespace orbicube::hexmesh
