// A matrix as a picture.
#pragma once

#include <cstddef>
#include <memory_resource>
#include <vector>

#include "base/array.h"

namespace orbicube::cli {

// A PNG of a square matrix of numbers that are not negative: black is zero, white the largest, as in the dissertation's
// figure 3.12. Rows and columns are numbered from 1, cells that are large enough show their number, and a scale stands
// on the right. The bytes of the file.
base::Array<std::byte> heat_map_png(const std::vector<std::vector<double>>& matrix, std::pmr::memory_resource* memory);

}  // namespace orbicube::cli
