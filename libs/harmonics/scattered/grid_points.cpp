#include "harmonics/scattered/grid_points.h"

#include <algorithm>
#include <array>

#include "harmonics/scattered/row_series.h"

namespace orbicube::harmonics {
namespace {

// Points and columns of a tile, in whose order points come within a band.
constexpr std::size_t tile_columns = 32;
// Points whose angles one task computes, and tasks between two reports.
constexpr std::size_t points_at_once = 1024, wave = 16;
// A unit has at most this number of bands, which limits how often rows between units are computed twice, and of points.
constexpr std::size_t max_bands = 4, max_points = 1 << 15;

// The first of the lines around a place, and the place between lines as the kernel takes it.
std::int32_t first_line(const GridPlace& place, double& between) {
  const bool above = place.rest > 0;
  between = (above ? 1 : -1) - 2 * place.rest;
  return place.line - static_cast<std::int32_t>(kernel_width / 2) + (above ? 1 : 0);
}

}  // namespace

GridPoints::GridPoints(std::span<const Vector3> unit, std::size_t rows, std::size_t columns, const char* phase,
                       const base::Host& host)
    : row_count_(rows / 2 + 1), points_(host.memory), band_start_(host.memory), units_(host.memory) {
  const GridAngles angles(rows, columns, host.memory);
  Array<GridPoint> unsorted(unit.size(), host.memory);
  for (std::size_t first = 0; first < unit.size(); first += points_at_once * wave) {
    host.report(phase, first, unit.size());
    host.parallel_for(wave, [&](std::size_t task) {
      std::array<GridPlace, GridAngles::at_once> row, column;
      const std::size_t begin = first + task * points_at_once, end = std::min(begin + points_at_once, unit.size());
      for (std::size_t i = begin; i < end; i += GridAngles::at_once) {
        const std::size_t count = std::min(GridAngles::at_once, end - i);
        angles.compute(unit.subspan(i, count), row.data(), column.data());
        for (std::size_t k = 0; k < count; ++k) {
          GridPoint& p = unsorted[i + k];
          p.first_row = first_line(row[k], p.row);
          p.first_column = first_line(column[k], p.column);
          p.index = i + k;
        }
      }
    });
  }
  constexpr auto margin = static_cast<std::int32_t>(grid_margin);
  const std::size_t tiles = (columns + 2 * grid_margin) / tile_columns + 1;
  const std::size_t bands = (row_count_ + grid_margin) / band_rows + 1;
  Array<std::size_t> start(bands * tiles + 1, host.memory);
  const auto tile = [&](const GridPoint& p) {
    return static_cast<std::size_t>(p.first_row + margin) / band_rows * tiles +
           static_cast<std::size_t>(p.first_column + margin) / tile_columns;
  };
  for (const GridPoint& p : unsorted)
    ++start[tile(p) + 1];
  for (std::size_t t = 1; t < start.size(); ++t)
    start[t] += start[t - 1];
  band_start_.resize(bands + 1);
  for (std::size_t b = 0; b <= bands; ++b)
    band_start_[b] = start[b * tiles];
  host.report(phase, 0, 0);
  points_.resize(unit.size());
  for (const GridPoint& p : unsorted)
    points_[start[tile(p)]++] = p;
  host.report(phase, 0, 0);
  divide();
}

void GridPoints::divide() {
  const std::size_t bands = band_start_.size() - 1;
  for (std::size_t band = 0; band < bands;) {
    std::size_t count = 1;
    while (count < max_bands && band + count < bands && band_start_[band + count + 1] - band_start_[band] <= max_points)
      ++count;
    const std::size_t end = band_start_[band + count];
    for (std::size_t begin = band_start_[band]; begin < end; begin += max_points)
      units_.push_back({band, count, begin, std::min(begin + max_points, end), 0});
    band += count;
  }
  // Rows come in their order, so a color is free again after the last row of its last unit.
  Array<std::size_t> free_from(units_.get_allocator().resource());
  for (GridUnit& unit : units_) {
    // Rows from that at -grid_margin. Those beyond the last are added to those before it.
    const std::size_t last = row_count_ - 1 + grid_margin;
    const std::size_t end = (unit.first_band + unit.bands) * band_rows + kernel_width;
    std::size_t first = unit.first_band * band_rows;
    if (end > last + 1) first = std::min(first, last - std::min(last, grid_margin + rows_at_once));
    while (unit.color < free_from.size() && free_from[unit.color] > first)
      ++unit.color;
    if (unit.color == free_from.size()) free_from.push_back(0);
    free_from[unit.color] = std::max(free_from[unit.color], end);
    color_count_ = std::max(color_count_, unit.color + 1);
  }
}

}  // namespace orbicube::harmonics
