// The value of a grid at points between its lines, and the transpose.
#pragma once

#include <cstddef>
#include <span>

#include "harmonics/scattered/grid_points.h"
#include "harmonics/scattered/spreading_kernel.h"

namespace orbicube::harmonics {

// Some rows of a grid: the place of column 0 in the first of them, and the numbers from one to the next.
template <class Number>
struct GridRows {
  Number* origin;
  std::ptrdiff_t first, stride;
};

// Writes values[index * channels] of each point's index.
void interpolate(const SpreadingKernel& kernel, std::span<const GridPoint> points, const GridRows<const double>& rows,
                 std::size_t channels, double* values);

// Adds weights[index] values[index * channels] to the grid; weights may be nullptr, for ones.
void spread(const SpreadingKernel& kernel, std::span<const GridPoint> points, const double* values,
            std::size_t channels, const double* weights, const GridRows<double>& rows);

}  // namespace orbicube::harmonics
