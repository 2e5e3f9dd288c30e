// Directions on the grid of a scattered transform, in the order of the grid, and how the work on them is divided.
#pragma once

#include <span>

#include "harmonics/scattered/grid_angles.h"
#include "harmonics/scattered/spreading_kernel.h"

namespace orbicube::harmonics {

// Rows whose points are worked on together.
inline constexpr std::size_t band_rows = 32;
// Rows and columns beyond the grid on either side that kernels of points on it reach.
inline constexpr std::size_t grid_margin = kernel_width / 2;

// The first grid lines around a direction, from -grid_margin, and its place between lines, from -1 to 1
// (spreading_kernel.h).
struct GridPoint {
  double row, column;
  std::int32_t first_row, first_column;
  std::size_t index;  // of the direction
};

// Points begin to end of some consecutive bands. Units of the same color, counted from 0, reach disjoint rows, also
// beyond the poles.
struct GridUnit {
  std::size_t first_band, bands, begin, end, color;
};

class GridPoints {
 public:
  // `rows` and `columns` in 2 pi, `row_count` from pole to pole.
  GridPoints(std::span<const Vector3> unit, std::size_t rows, std::size_t columns, const char* phase,
             const base::Host& host);

  std::span<const GridPoint> points() const { return points_; }
  // Points of the bands before `band`, whose first row is band * band_rows - grid_margin.
  std::size_t band_start(std::size_t band) const { return band_start_[band]; }
  std::span<const GridUnit> units() const { return units_; }
  std::size_t color_count() const { return color_count_; }

 private:
  void divide();

  std::size_t row_count_;
  Array<GridPoint> points_;
  Array<std::size_t> band_start_;
  Array<GridUnit> units_;
  std::size_t color_count_ = 0;
};

}  // namespace orbicube::harmonics
