// Points in the order in which a Hilbert curve passes them: those that follow each other are near each other, so that
// arrays in this order use caches well and pieces of it are compact regions.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

// The place of a cell of a grid with 2^21 cells an axis along the curve (Skilling 2004, "Programming the Hilbert
// curve").
std::uint64_t hilbert_key(std::array<std::uint32_t, 3> cell);

// The numbers of the points in the order of the curve through their bounding cube; equal places by number. O(n log n).
base::Array<Index> hilbert_order(std::span<const Vector3> points, const base::Host& host);

}  // namespace orbicube::mesh
