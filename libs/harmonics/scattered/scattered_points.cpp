// The grid of a scattered transform: its margins, and the way between it and the points.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vector_variants.h"
#include "harmonics/scattered/scattered_transform.h"

namespace orbicube::harmonics {
namespace {

using Powers = std::array<KernelValues, SpreadingKernel::power_count>;

constexpr std::size_t points_at_once = 1024, wave = 16;
// Rows of a band, at least kernel_width: points of every other band touch disjoint rows. Columns of a tile.
constexpr std::size_t band_rows = 32, tile_columns = 32;

// First of the kernel_width grid lines around a coordinate.
ORBICUBE_INLINE std::ptrdiff_t first_line(double at) {
  return static_cast<std::ptrdiff_t>(std::ceil(at - 0.5 * static_cast<double>(kernel_width)));
}

ORBICUBE_INLINE void kernel_values(const Powers& powers, double at, std::ptrdiff_t first, KernelValues& values) {
  const double x = 2 * (static_cast<double>(first) - at) + static_cast<double>(kernel_width) - 1;
  values = powers[0];
  for (std::size_t p = 1; p < powers.size(); ++p) {
    for (std::size_t k = 0; k < kernel_width; ++k)
      values[k] = values[k] * x + powers[p][k];
  }
}

ORBICUBE_VECTOR_VARIANTS
double value_at(const Powers& powers, double row, double column, const double* origin, std::ptrdiff_t width) {
  const std::ptrdiff_t first_row = first_line(row), first_column = first_line(column);
  KernelValues of_row, of_column, sum{};
  kernel_values(powers, row, first_row, of_row);
  kernel_values(powers, column, first_column, of_column);
  const double* from = origin + first_row * width + first_column;
  for (std::size_t r = 0; r < kernel_width; ++r, from += width) {
    for (std::size_t k = 0; k < kernel_width; ++k)
      sum[k] += of_row[r] * from[k];
  }
  double value = 0;
  for (std::size_t k = 0; k < kernel_width; ++k)
    value += sum[k] * of_column[k];
  return value;
}

ORBICUBE_VECTOR_VARIANTS
void add_at(const Powers& powers, double row, double column, double value, double* origin, std::ptrdiff_t width) {
  const std::ptrdiff_t first_row = first_line(row), first_column = first_line(column);
  KernelValues of_row, of_column;
  kernel_values(powers, row, first_row, of_row);
  kernel_values(powers, column, first_column, of_column);
  double* to = origin + first_row * width + first_column;
  for (std::size_t r = 0; r < kernel_width; ++r, to += width) {
    const double factor = of_row[r] * value;
    for (std::size_t k = 0; k < kernel_width; ++k)
      to[k] += factor * of_column[k];
  }
}

}  // namespace

void ScatteredTransform::sort_points(std::span<const Vector3> unit) {
  const double row_scale = static_cast<double>(row_transform_.length()) / (2 * std::numbers::pi);
  const double length = static_cast<double>(column_transform_.length());
  const double column_scale = length / (2 * std::numbers::pi);
  const std::size_t tiles = static_cast<std::size_t>(width_) / tile_columns + 1;
  const std::size_t bands = (row_count_ + 2 * pad) / band_rows + 1;
  Array<Point> unsorted(unit.size(), host_.memory);
  Array<std::size_t> start(bands * tiles + 1, host_.memory);
  const auto tile = [&](const Point& p) {
    const auto row = static_cast<std::size_t>(first_line(p.row) + pad);
    const auto column = static_cast<std::size_t>(first_line(p.column) + pad);
    return row / band_rows * tiles + column / tile_columns;
  };
  for (std::size_t first = 0; first < unit.size(); first += points_at_once * wave) {
    host_.report(phase_, first, unit.size());
    host_.parallel_for(wave, [&](std::size_t task) {
      const std::size_t begin = first + task * points_at_once, end = std::min(begin + points_at_once, unit.size());
      for (std::size_t i = begin; i < end; ++i) {
        const Vector3& d = unit[i];
        const double turn = std::atan2(d.y(), d.x()) * column_scale;
        unsorted[i] = {std::atan2(std::hypot(d.x(), d.y()), d.z()) * row_scale, turn < 0 ? turn + length : turn, i};
      }
    });
  }
  for (const Point& p : unsorted)
    ++start[tile(p) + 1];
  for (std::size_t t = 1; t < start.size(); ++t)
    start[t] += start[t - 1];
  band_start_.resize(bands + 1);
  for (std::size_t b = 0; b <= bands; ++b)
    band_start_[b] = start[b * tiles];
  points_.resize(unit.size());
  for (const Point& p : unsorted)
    points_[start[tile(p)]++] = p;
}

void ScatteredTransform::write_rows(std::size_t first, const ComplexLanes* data) {
  for (std::size_t i = 0; i < fourier_lanes && first + 2 * i < row_count_; ++i) {
    double* row = grid_row(static_cast<std::ptrdiff_t>(first + 2 * i));
    for (std::size_t p = 0; p < column_transform_.length(); ++p)
      row[p] = data[p].real[i];
    if (first + 2 * i + 1 >= row_count_) continue;
    row += width_;
    for (std::size_t p = 0; p < column_transform_.length(); ++p)
      row[p] = data[p].imaginary[i];
  }
}

void ScatteredTransform::read_rows(std::size_t first, ComplexLanes* data) {
  std::fill_n(data, column_transform_.length(), ComplexLanes{});
  for (std::size_t i = 0; i < fourier_lanes && first + 2 * i < row_count_; ++i) {
    const double* row = grid_row(static_cast<std::ptrdiff_t>(first + 2 * i));
    for (std::size_t p = 0; p < column_transform_.length(); ++p)
      data[p].real[i] = row[p];
    if (first + 2 * i + 1 >= row_count_) continue;
    row += width_;
    for (std::size_t p = 0; p < column_transform_.length(); ++p)
      data[p].imaginary[i] = row[p];
  }
}

// Beyond a pole a row goes on as the one on the other side, half a turn further.
void ScatteredTransform::pad_grid() {
  const auto length = static_cast<std::ptrdiff_t>(column_transform_.length());
  for (std::ptrdiff_t r = 0; r <= last_row(); ++r) {
    double* row = grid_row(r);
    std::copy_n(row + length - pad, pad, row - pad);
    std::copy_n(row, pad, row + length);
  }
  for (std::ptrdiff_t r = 1; r <= pad; ++r) {
    for (const auto& [to, from] : {std::pair(-r, r), std::pair(last_row() + r, last_row() - r)}) {
      for (std::ptrdiff_t c = -pad; c < length + pad; ++c)
        grid_row(to)[c] = grid_row(from)[(c + length + length / 2) % length];
    }
  }
}

// The transpose.
void ScatteredTransform::fold_grid() {
  const auto length = static_cast<std::ptrdiff_t>(column_transform_.length());
  for (std::ptrdiff_t r = 1; r <= pad; ++r) {
    for (const auto& [from, to] : {std::pair(-r, r), std::pair(last_row() + r, last_row() - r)}) {
      for (std::ptrdiff_t c = -pad; c < length + pad; ++c)
        grid_row(to)[(c + length + length / 2) % length] += grid_row(from)[c];
    }
  }
  for (std::ptrdiff_t r = 0; r <= last_row(); ++r) {
    double* row = grid_row(r);
    for (std::ptrdiff_t c = 0; c < pad; ++c) {
      row[length - pad + c] += row[c - pad];
      row[c] += row[length + c];
    }
  }
}

void ScatteredTransform::interpolate(std::size_t channels, std::size_t channel, std::span<double> values) {
  const double* origin = grid_row(0);
  for (std::size_t first = 0; first < points_.size(); first += points_at_once * wave) {
    host_.report(phase_, first, points_.size());
    host_.parallel_for(wave, [&](std::size_t task) {
      const std::size_t begin = first + task * points_at_once, end = std::min(begin + points_at_once, points_.size());
      for (std::size_t i = begin; i < end; ++i) {
        const Point& p = points_[i];
        values[p.index * channels + channel] = value_at(kernel_.powers(), p.row, p.column, origin, width_);
      }
    });
  }
}

// Every other band at a time, some points of each between two reports: what is added to a row comes in one order.
void ScatteredTransform::spread(std::span<const double> weights, std::span<const double> values, std::size_t channels,
                                std::size_t channel) {
  std::fill(grid_.begin(), grid_.end(), 0.0);
  double* origin = grid_row(0);
  const std::size_t bands = band_start_.size() - 1;
  for (std::size_t odd = 0; odd < 2; ++odd) {
    bool more = true;
    for (std::size_t done = 0; more; done += points_at_once) {
      more = false;
      for (std::size_t b = odd; b < bands; b += 2)
        more = more || band_start_[b] + done + points_at_once < band_start_[b + 1];
      host_.report(phase_, 0, 0);
      host_.parallel_for((bands + 1 - odd) / 2, [&](std::size_t task) {
        const std::size_t band = 2 * task + odd, begin = band_start_[band] + done;
        const std::size_t end = std::min(begin + points_at_once, band_start_[band + 1]);
        for (std::size_t i = begin; i < end; ++i) {
          const Point& p = points_[i];
          const double value = values[p.index * channels + channel] * (weights.empty() ? 1 : weights[p.index]);
          add_at(kernel_.powers(), p.row, p.column, value, origin, width_);
        }
      });
    }
  }
}

}  // namespace orbicube::harmonics
