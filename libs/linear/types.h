// Types that all systems share.
#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <memory_resource>

#include "base/array.h"

namespace orbicube::linear {

using base::Array;

using Index = std::uint32_t;
inline constexpr Index no_index = 0xffffffffU;

// Columns of the lower triangle of a symmetric matrix, rows ascending, the whole diagonal among them.
using SparseMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
using Triplets = std::pmr::vector<Eigen::Triplet<double, int>>;

}  // namespace orbicube::linear
