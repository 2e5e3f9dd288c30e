// How much of any box is inside a closed surface: signed crossings of rays along z with the surface on a fine grid, and
// their prefix sums.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::polycube {

using base::Array;
using mesh::Triangle;
using mesh::Vector3;

class Occupancy {
 public:
  // `resolution` cells along the longest axis. The surface must be closed and outward-oriented; where it overlaps
  // itself, what is wound around at least once is inside. O(resolution^3 + resolution * area).
  Occupancy(std::span<const Vector3> positions, std::span<const Triangle> triangles, int resolution,
            const base::Host& host);

  int count(std::size_t axis) const { return counts_[axis]; }
  double cell_size() const { return size_; }
  const Vector3& low() const { return low_; }
  int resolution() const { return resolution_; }

  // Cells that are inside in the box from `begin` to `end` (exclusive), clipped to the grid.
  std::int64_t inside(std::array<int, 3> begin, std::array<int, 3> end) const;

 private:
  std::size_t place(int x, int y, int z) const {
    const auto index = [](int i) { return static_cast<std::size_t>(i); };
    return (index(x) * index(counts_[1] + 1) + index(y)) * index(counts_[2] + 1) + index(z);
  }

  int resolution_;
  double size_ = 0;
  Vector3 low_;
  std::array<int, 3> counts_{};
  Array<std::uint32_t> sums_;
};

}  // namespace orbicube::polycube
