// Voxels of an object in a box with layers of background around it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/array.h"

namespace orbicube::repair {

using VoxelIndex = std::size_t;

// One byte a voxel, x fastest: 1 in the object, 0 in the background. The outermost layer is background, so that each
// voxel inside of it has 26 neighbors.
struct Voxels {
  Voxels(const std::array<std::size_t, 3>& size_, std::pmr::memory_resource* memory)
      : size(size_), in(size_[0] * size_[1] * size_[2], 0, memory) {}

  VoxelIndex index(std::size_t x, std::size_t y, std::size_t z) const { return x + size[0] * (y + size[1] * z); }
  std::array<std::size_t, 3> place(VoxelIndex v) const {
    return {v % size[0], v / size[0] % size[1], v / (size[0] * size[1])};
  }
  std::ptrdiff_t stride(int axis) const {
    return static_cast<std::ptrdiff_t>(axis == 0 ? 1 : axis == 1 ? size[0] : size[0] * size[1]);
  }
  // The offset of neighbor n, bit n of a Neighborhood: n = (dx + 1) + 3 (dy + 1) + 9 (dz + 1).
  std::ptrdiff_t offset(int n) const {
    return (n % 3 - 1) * stride(0) + (n / 3 % 3 - 1) * stride(1) + (n / 9 - 1) * stride(2);
  }
  std::pmr::memory_resource* memory() const { return in.get_allocator().resource(); }

  std::array<std::size_t, 3> size;
  base::Array<std::uint8_t> in;
};

}  // namespace orbicube::repair
