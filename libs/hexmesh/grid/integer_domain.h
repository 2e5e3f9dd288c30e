// A polycube whose faces are moved to integer planes, near to where they are in units of a cell: then its cells fill it
// without a rest.
#pragma once

#include "hexmesh/types.h"
#include "polycube/outputs/patch_graph.h"

namespace orbicube::hexmesh {

using polycube::PatchGraph;
using Cell = std::array<int, 3>;

class IntegerDomain {
 public:
  // Cells of about this length on the polycube. Planes of neighboring numbers stay at least one cell apart, and what
  // is crossed between two changes of inside and outside gets at least `across` cells. The numbers minimize, along each
  // axis, the sum over what is crossed between two changes of inside and outside of area (cells - length)^2 /
  // max(length, 1), lengths in cells. Throws Error "invalid-argument" where that would be more than 10^8 cells,
  // "cancelled".
  IntegerDomain(const PatchGraph& graph, double cell_length, const base::Host& host, int across = 1);

  // Where a point of the polycube is here: linear between planes.
  Vector3 place(const Vector3& p) const;

  // Cells along an axis, of the box around all; the box begins at 0.
  int size(std::size_t axis) const { return size_[axis]; }
  bool inside(const Cell& cell) const {
    for (std::size_t a = 0; a < 3; ++a) {
      if (cell[a] < 0 || cell[a] >= size_[a]) return false;
    }
    return inside_[index(cell)] != 0;
  }
  // Of each cell of the box, the last axis fastest.
  std::span<const std::uint8_t> inside() const { return inside_; }
  std::size_t cells() const { return cells_; }
  // Faces of cells on the boundary.
  std::size_t faces() const { return faces_; }

 private:
  std::size_t index(const Cell& c) const {
    return (static_cast<std::size_t>(c[0]) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(c[1])) *
               static_cast<std::size_t>(size_[2]) +
           static_cast<std::size_t>(c[2]);
  }

  std::array<Array<double>, 3> planes_;
  std::array<Array<int>, 3> numbers_;  // of the planes
  std::array<int, 3> size_{};
  Array<std::uint8_t> inside_;
  std::size_t cells_ = 0, faces_ = 0;
};

// The domain of about the given number of cells, and a layer of one more on the part `padded` of the faces of the
// boundary.
IntegerDomain domain_of_cells(const PatchGraph& graph, std::size_t cells, double padded, const base::Host& host,
                              int across = 1);

}  // namespace orbicube::hexmesh
