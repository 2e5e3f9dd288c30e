// Fewer corners for a voxel polycube: faces, or rectangles of them, are pushed out or in until corners vanish.
//
// A push is a set of simple flips (voxel_solid.h) or nothing, so that the topology never changes. The pushes that cost
// least for each corner that they remove come first. The cost is the volume that becomes wrong, divided by the squared
// local thickness: a thin protrusion then counts by its length, as much as a slice of the body, and survives longer.
#pragma once

#include "polycube/voxels/voxelisation.h"

namespace orbicube::polycube {

class Simplification {
 public:
  // Works on a copy of the solid. First flips single cells that fit the surface better flipped.
  Simplification(const Voxelisation& voxels, const base::Host& host);

  // Goes on until there are at most this many corners. False when no push helps any more.
  bool reduce(std::size_t corners);

  const VoxelSolid& solid() const { return solid_; }
  std::size_t corners() const { return static_cast<std::size_t>(corners_); }

 private:
  using Square = std::array<int, 2>;
  // Squares of one patch of the polycube, in the plane between the inside cells of `layer` and their neighbors in
  // direction `sign`.
  struct Push {
    std::size_t axis;
    int sign, layer;
    bool inward;
    std::size_t begin, end;  // its squares in squares_
  };
  struct Outcome {
    std::int64_t corners = 0;
    double cost = 0;
  };
  struct Candidate {
    double rate;
    std::size_t push;
  };

  void fit_cells();
  void fit_faces();
  void find_pushes();
  void add_pushes(std::size_t axis, int sign, int layer, std::size_t begin, std::size_t end);
  bool still_a_face(const Push& push) const;
  // Flips what the push wants of one layer, in some order in which each flip is simple; false, with flips left to be
  // undone, when there is none.
  bool flip_layer(const Push& push, int depth, Outcome& outcome);
  // Pushes until there are fewer corners; leaves nothing changed, and returns false, when that does not happen.
  bool apply(const Push& push, int max_layers, Outcome& outcome);
  void undo();
  static double rate(const Outcome& outcome);
  Cell cell_of(const Push& push, const Square& square, int depth) const;

  const base::Host& host_;
  VoxelSolid solid_;
  std::int64_t corners_ = 0;
  Array<float> weight_;  // cost of being inside minus cost of being outside
  Array<Push> pushes_;
  Array<Square> squares_;
  Array<std::uint8_t> marks_;
  Array<Candidate> candidates_;
  Array<Cell> flipped_, waiting_, refused_;
};

}  // namespace orbicube::polycube
