// A solid made of the cells of a grid, its surface certified to be a manifold: what the polycubes of the voxel
// construction are before they become layouts.
//
// Everything local is decided by the eight cells around a grid vertex, by tables of 256 entries. A flip (a cell put in
// or taken out) is simple when the cell's exposed faces and their complement are both connected and all eight
// configurations stay manifold; simple flips keep the topology of the surface and of both sides (Bertrand and Malandain
// 1994).
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::polycube {

using base::Array;
using mesh::Index;
using mesh::no_index;
using mesh::Vector3;

using Cell = std::array<int, 3>;

struct VoxelTopology {
  std::size_t bad_vertices =
      0;                   // around which the surface is no manifold; the rest means something when there are none
  std::int64_t genus = 0;  // of the whole surface, by its Euler number
  std::size_t inside_components = 0, outside_components = 0;
};

class VoxelSolid {
 public:
  // `planes` of each axis in ascending order; all cells are outside. At least three cells an axis: the outermost layers
  // always stay outside.
  VoxelSolid(std::array<Array<double>, 3> planes, std::pmr::memory_resource* memory);

  int count(std::size_t axis) const { return static_cast<int>(planes_[axis].size()) - 1; }
  std::size_t size() const { return inside_.size(); }
  std::span<const double> planes(std::size_t axis) const { return planes_[axis]; }
  Vector3 position(const Cell& vertex) const {
    const auto at = [&](std::size_t axis) { return planes_[axis][static_cast<std::size_t>(vertex[axis])]; };
    return {at(0), at(1), at(2)};
  }

  std::size_t place(const Cell& cell) const {
    return (static_cast<std::size_t>(cell[0]) * count_y_ + static_cast<std::size_t>(cell[1])) * count_z_ +
           static_cast<std::size_t>(cell[2]);
  }
  Cell cell(std::size_t place) const {
    return {static_cast<int>(place / (count_y_ * count_z_)), static_cast<int>(place / count_z_ % count_y_),
            static_cast<int>(place % count_z_)};
  }
  // How far apart the places of neighbors along an axis are.
  std::size_t stride(std::size_t axis) const { return axis == 0 ? count_y_ * count_z_ : axis == 1 ? count_z_ : 1; }
  // The place of the neighbor above (sign > 0) or below along an axis.
  std::size_t neighbor(std::size_t place, std::size_t axis, int sign) const {
    return sign > 0 ? place + stride(axis) : place - stride(axis);
  }
  // visit(neighbor) for each cell of the grid that shares a face with the cell at `place`.
  template <class Visit>
  void for_each_neighbor(std::size_t place, const Visit& visit) const {
    const Cell c = cell(place);
    for (std::size_t a = 0; a < 3; ++a) {
      for (const int step : {-1, 1})
        if (c[a] + step >= 0 && c[a] + step < count(a)) visit(neighbor(place, a, step));
    }
  }
  bool inside(std::size_t place) const { return inside_[place] != 0; }
  bool inside(const Cell& cell) const { return inside_[place(cell)] != 0; }
  void set(std::size_t place, bool inside) { inside_[place] = inside; }
  bool in_outermost_layer(const Cell& cell) const {
    for (std::size_t a = 0; a < 3; ++a)
      if (cell[a] < 1 || cell[a] >= count(a) - 1) return true;
    return false;
  }

  // Bit b is set when the cell at vertex + (b & 1, b >> 1 & 1, b >> 2 & 1) - 1 is inside. For vertices of the grid that
  // are not on its border.
  unsigned configuration(const Cell& vertex) const;
  static bool manifold(unsigned configuration);
  // Whether three edges of the polycube or more meet there.
  static bool corner(unsigned configuration);

  // Puts the cell in or takes it out when that is simple, and adds what it changes in the number of corners.
  bool flip_if_simple(const Cell& cell, std::int64_t& corners);

  // How many of the eight vertices of a cell are not manifold.
  int bad_vertices(const Cell& cell) const;

  std::size_t corners() const;
  VoxelTopology topology(const base::Host& host) const;

  // Of the cells that are inside (or those that are not), all but the largest component change sides.
  void keep_largest(bool inside, const base::Host& host);

 private:
  // Numbers the components: of each place into marks, with their sizes.
  std::size_t components(bool inside, Array<Index>& marks, Array<std::size_t>& sizes, const base::Host& host) const;

  std::array<Array<double>, 3> planes_;
  std::size_t count_y_, count_z_;
  Array<std::uint8_t> inside_;
};

}  // namespace orbicube::polycube
