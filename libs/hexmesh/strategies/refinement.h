// How many cells the next mesh gets while meshes are too far from the surface, and when more cells do not lead there.
#pragma once

#include <cstddef>
#include <utility>

namespace orbicube::hexmesh {

// Meshes with more and more cells, up to a maximum. The distance of the last one gives the minimum number of
// cells that is needed; by how much more cells helped, whether there can be enough.
class Refinement {
 public:
  Refinement(std::size_t cells, std::size_t max_cells) : cells_(cells), max_cells_(max_cells) {}

  std::size_t cells() const { return cells_; }
  // After a mesh of cells() with this excess() (hex_draft.h); 0: there is none. `nearest`: that of the nearest mesh by
  // any strategy, or 0. Returns whether cells() now is a larger number that is worth a mesh.
  bool next(double excess, double nearest);
  // What helped is unknown from now on: the strategy changes.
  void forget() {
    excess_before_ = 0;
    slow_ = 0;
  }

 private:
  std::size_t cells_, max_cells_;
  // Of the mesh before the last one; 0: there was none.
  double excess_before_ = 0;
  std::size_t cells_before_ = 0;
  int slow_ = 0;  // times in a row that more cells hardly helped
};

// Whether a mesh of `cells` may have no excess(), after one of others, pair of their number and its excess().
bool may_be_near(const std::pair<std::size_t, double>& before, std::size_t cells);

}  // namespace orbicube::hexmesh
