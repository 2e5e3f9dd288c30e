#include "harmonics/scattered/scattered_transform.h"

#include <algorithm>

#include "harmonics/scattered/kernel_sums.h"

namespace orbicube::harmonics {
namespace {

// Lines of the grid for each of the 2 L + 1 frequencies, at least (spreading_kernel.h): 3600 at degree 1000. Less makes
// the transforms shorter, and errors larger.
constexpr double min_oversampling = 1.79;
// A kernel and its mirror image fit in this number of lines.
constexpr std::size_t min_length = 64;

std::size_t oversampled(std::uint32_t degree) {
  const double least = min_oversampling * (2.0 * degree + 1);
  return FourierTransform::fitting_length(std::max(min_length, static_cast<std::size_t>(least) + 1));
}

double oversampling(std::uint32_t degree) {
  return static_cast<double>(oversampled(degree)) / (2.0 * degree + 1);
}

}  // namespace

ScatteredTransform::ScatteredTransform(std::span<const Vector3> unit, std::uint32_t degree, const char* phase,
                                       const base::Host& host)
    : phase_(phase),
      host_(host),
      rows_(oversampled(degree)),
      kernel_(oversampling(degree)),
      order_series_(degree, rows_, kernel_, host),
      row_series_(degree, rows_, kernel_, host),
      points_(unit, rows_, rows_, phase, host),
      orders_(degree, rows_ / 2 + 1, host.memory),
      slots_(host),
      work_(host.memory) {
  work_.reserve(slots_.count());
  for (std::size_t k = 0; k < slots_.count(); ++k) {
    work_.push_back(
        {Array<double>(slab_rows * stride(), host.memory), Array<ComplexLanes>(row_series_.work_size(), host.memory)});
  }
}

bool ScatteredTransform::pays(std::size_t directions, std::uint32_t degree) {
  constexpr std::uint32_t min_degree = 80;
  // Nanoseconds of one core: of a basis function at a point, of a point on the grid, of a function at a circle, of an
  // entry of the grid.
  constexpr double of_function = 0.42, of_point = 110, of_circle = 0.17, of_entry = 4;
  const double n = static_cast<double>(directions), size = degree + 1.0, functions = size * (size + 1) / 2;
  const double fast = n * of_point + size * functions * of_circle + 7 * size * size * of_entry;
  return degree >= min_degree && n * functions * of_function > 2 * fast;
}

void ScatteredTransform::synthesise(const Coefficients& coefficients, std::size_t channel, std::span<double> values) {
  order_series_.synthesise(coefficients, channel, phase_, orders_);
  run_units([&](const GridUnit& unit, std::size_t slot) {
    read_unit(unit, coefficients.channels, values.data() + channel, work_[slot]);
  });
}

void ScatteredTransform::analyse(std::span<const double> weights, std::span<const double> values, std::size_t channel,
                                 Coefficients& coefficients) {
  std::fill(orders_.values.begin(), orders_.values.end(), ComplexLanes{});
  run_units([&](const GridUnit& unit, std::size_t slot) {
    add_unit(unit, weights.empty() ? nullptr : weights.data(), values.data() + channel, coefficients.channels,
             work_[slot]);
  });
  order_series_.analyse(orders_, channel, phase_, coefficients);
}

// One color after the other, some units of one at a time.
template <class Body>
void ScatteredTransform::run_units(const Body& body) {
  constexpr std::size_t points_between_reports = 1 << 17;
  const std::span<const GridUnit> units = points_.units();
  std::array<const GridUnit*, Slots::max_count> now;
  std::size_t count = 0, points = 0, done = 0;
  const auto flush = [&] {
    host_.report(phase_, done, points_.points().size());
    slots_.run(host_, 0, count, [&](std::size_t task, std::size_t slot) { body(*now[task], slot); });
    done += points;
    count = points = 0;
  };
  for (std::size_t color = 0; color < points_.color_count(); ++color) {
    for (const GridUnit& unit : units) {
      if (unit.color != color) continue;
      now[count++] = &unit;
      points += unit.end - unit.begin;
      if (count == now.size() || points >= points_between_reports) flush();
    }
    if (count > 0) flush();
  }
}

bool ScatteredTransform::is_reached(std::ptrdiff_t row) const {
  return row < static_cast<std::ptrdiff_t>(orders_.row_count + grid_margin);
}

// Rows are computed eight at a time as the bands need them; those that the next band needs as well stay.
void ScatteredTransform::read_unit(const GridUnit& unit, std::size_t channels, double* values, Work& work) const {
  const std::size_t width = stride();
  for (std::size_t b = 0; b < unit.bands; ++b) {
    const std::size_t band = unit.first_band + b;
    const std::ptrdiff_t first =
        static_cast<std::ptrdiff_t>(band * band_rows) - static_cast<std::ptrdiff_t>(grid_margin);
    std::size_t known = 0;
    if (b > 0) {
      known = kernel_width;
      std::copy_n(&work.rows[band_rows * width], kernel_width * width, work.rows.data());
    }
    for (std::size_t r = known; r < slab_rows; r += rows_at_once) {
      const std::ptrdiff_t row = first + static_cast<std::ptrdiff_t>(r);
      if (is_reached(row))
        row_series_.synthesise(orders_, row, grid_margin, width, &work.rows[r * width + grid_margin],
                               work.series.data());
    }
    const std::size_t begin = std::max(unit.begin, points_.band_start(band));
    const std::size_t end = std::min(unit.end, points_.band_start(band + 1));
    if (begin >= end) continue;
    interpolate(kernel_, points_.points().subspan(begin, end - begin),
                {work.rows.data() + grid_margin, first, static_cast<std::ptrdiff_t>(width)}, channels, values);
  }
}

// The transpose.
void ScatteredTransform::add_unit(const GridUnit& unit, const double* weights, const double* values,
                                  std::size_t channels, Work& work) {
  const std::size_t width = stride();
  std::fill_n(work.rows.begin(), kernel_width * width, 0.0);
  for (std::size_t b = 0; b < unit.bands; ++b) {
    const std::size_t band = unit.first_band + b;
    const std::ptrdiff_t first =
        static_cast<std::ptrdiff_t>(band * band_rows) - static_cast<std::ptrdiff_t>(grid_margin);
    std::fill_n(&work.rows[kernel_width * width], band_rows * width, 0.0);
    const std::size_t begin = std::max(unit.begin, points_.band_start(band));
    const std::size_t end = std::min(unit.end, points_.band_start(band + 1));
    if (begin < end)
      spread(kernel_, points_.points().subspan(begin, end - begin), values, channels, weights,
             {work.rows.data() + grid_margin, first, static_cast<std::ptrdiff_t>(width)});
    const std::size_t complete = b + 1 < unit.bands ? band_rows : slab_rows;
    for (std::size_t r = 0; r < complete; r += rows_at_once) {
      const std::ptrdiff_t row = first + static_cast<std::ptrdiff_t>(r);
      if (is_reached(row))
        row_series_.analyse(&work.rows[r * width + grid_margin], row, grid_margin, width, orders_, work.series.data());
    }
    std::copy_n(&work.rows[band_rows * width], kernel_width * width, work.rows.data());
  }
}

}  // namespace orbicube::harmonics
