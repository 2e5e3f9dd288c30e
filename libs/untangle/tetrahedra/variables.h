// The unknowns of a map of tetrahedra: coordinates of vertices, some of which stay as they are and some of which are
// one and the same number, as those of a patch of a polycube along its normal.
#pragma once

#include <cstdint>
#include <span>

#include "untangle/types.h"

namespace orbicube::untangle {

// Coordinates are numbered 3 vertex + axis. Free variables are numbered before those that stay.
class Variables {
 public:
  // `fixed` has an entry a coordinate, not 0 where it stays as `start` has it; `ties` has the group that a coordinate
  // belongs to, all of which are equal, or no_index. Either may be empty. A group with a fixed coordinate is fixed; one
  // without starts at the mean of its coordinates. Throws Error "invalid-argument" for arrays of another length, a
  // group that is not below the number of coordinates, a start that is not finite, and a group that is fixed at two
  // values.
  Variables(std::span<const Vector3> start, std::span<const std::uint8_t> fixed, std::span<const Index> ties,
            std::pmr::memory_resource* memory);

  // What a coordinate is in terms of unknowns: sign times one of them plus a shift, or the shift alone.
  struct Affine {
    Index unknown;  // or no_index
    int sign;
    double shift;
  };
  // Coordinates that are such functions of unknowns, as those of a map whose charts meet by rotations of the cube and
  // translations. `start` has an entry an unknown. An unknown of one coordinate alone becomes that coordinate.
  Variables(std::span<const Affine> coordinates, std::span<const double> start, std::pmr::memory_resource* memory);

  std::size_t vertices() const { return variable_.size() / 3; }
  std::size_t own() const { return own_; }  // free variables of one coordinate, numbered first
  std::size_t free() const { return free_; }
  std::size_t size() const { return start_.size(); }
  Index of(std::size_t vertex, std::size_t axis) const { return variable_[3 * vertex + axis]; }
  bool is_free(std::size_t vertex, std::size_t axis) const { return of(vertex, axis) < free_; }
  // Whether the coordinate is free and has its variable for itself.
  bool is_own(std::size_t vertex, std::size_t axis) const { return of(vertex, axis) < own_; }
  bool any_shared() const { return own_ < free_; }
  // Whether a coordinate is minus its variable plus something.
  bool any_flipped() const { return !flipped_.empty(); }
  bool is_flipped(std::size_t vertex, std::size_t axis) const {
    return any_flipped() && (flipped_[vertex] >> axis & 1) != 0;
  }
  // Of all variables.
  std::span<const double> start() const { return start_; }

  // The coordinates of all vertices from the variables.
  void expand(std::span<const double> values, std::span<Vector3> positions) const {
    expand_change(values, positions);
    for (const Shared& s : shared_)
      positions[s.coordinate / 3][static_cast<Eigen::Index>(s.coordinate % 3)] += s.shift;
  }
  // Changes of coordinates from changes of the variables.
  void expand_change(std::span<const double> values, std::span<Vector3> positions) const {
    for (std::size_t v = 0; v < positions.size(); ++v) {
      for (std::size_t a = 0; a < 3; ++a)
        positions[v][static_cast<Eigen::Index>(a)] = values[variable_[3 * v + a]];
    }
    for (const Shared& s : shared_) {
      if (s.sign < 0) {
        double& x = positions[s.coordinate / 3][static_cast<Eigen::Index>(s.coordinate % 3)];
        x = -x;
      }
    }
  }
  // The derivative by the variables from that by the coordinates: sums over groups, 0 for what stays.
  void reduce(std::span<const Vector3> forces, std::span<double> sums) const;

 private:
  // A coordinate that is not just its variable.
  struct Shared {
    Index coordinate;
    int sign;
    double shift;
  };
  Array<Shared> shared_;         // in ascending order of coordinates
  Array<std::uint8_t> flipped_;  // of each vertex, where there are any: bit `axis` for a sign of -1
  Array<Index> variable_;        // of each coordinate; own ones first, then groups, then fixed ones
  Array<double> start_;
  std::size_t own_ = 0, free_ = 0;
};

}  // namespace orbicube::untangle
