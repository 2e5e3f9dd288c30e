// The sharp lines of the boundary of a mesh of hexahedra, before and after sheets of hexahedra cross them.
#pragma once

#include <map>
#include <utility>

#include "hexmesh/features/boundary_quads.h"
#include "mesh/search/nearest.h"

namespace orbicube::hexmesh {

// Numbers of the first hexahedra of sheets along the faces between regions, and of rings around these sheets.
struct Sheets {
  std::size_t first = 0, second = 0;
};

// Patches of quads between sharp edges, and the lines between two of them.
class BoundaryLines {
 public:
  // Of a mesh before the sheets; a copy of its lines is kept.
  BoundaryLines(const HexMesh& mesh, const base::Host& host);

  // The patch of a quad of the boundary before there were sheets; no_index of others.
  Index patch_of(const Quad& quad) const;
  // With the sheets: the patch of each quad of the boundary now.
  Array<Index> patches_of(const BoundaryQuads& quads, const Sheets& sheets) const;

  // The nearest point of the line between two patches, and its tangent; not found where they have none.
  struct Point {
    Vector3 position = Vector3::Zero(), tangent = Vector3::Zero();
    double distance = std::numeric_limits<double>::infinity();
  };
  Point nearest(std::pair<Index, Index> patches, const Vector3& p) const;
  // Whether a vertex is the end of a sharp edge with the same patch on both sides, or where a line bends.
  bool is_special(Index vertex) const { return vertex < special_.size() && special_[vertex] != 0; }

 private:
  static std::size_t face_of(const Hexahedron& h, const Quad& quad);
  void find_patches(const BoundaryQuads& quads);
  void find_lines(const BoundaryQuads& quads);
  bool is_sharp(const BoundaryQuads& quads, Index half_edge) const;

  const base::Host& host_;
  const HexMesh& mesh_;
  Array<Vector3> positions_;
  Array<Index> patch_of_face_;           // of each of the six faces of each hexahedron
  Array<Index> patch_;                   // of each quad
  std::map<Quad, Index> patch_of_quad_;  // by its vertices in ascending order
  Array<std::uint8_t> special_;
  std::map<std::pair<Index, Index>, Array<std::array<Index, 2>>> lines_;
};

}  // namespace orbicube::hexmesh
