#include "harmonics/scattered/scattered_transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace orbicube::harmonics {
namespace {

// Tasks between two reports.
constexpr std::size_t wave = 16;
// Lengths of grids are at least this number, so that margins fit.
constexpr std::size_t min_length = 64;

std::size_t oversampled(std::uint32_t degree) {
  return FourierTransform::fitting_length(std::max(min_length, 4 * std::size_t{degree} + 4));
}

// to = radius^m.
void power(const Lanes& radius, std::uint32_t m, Lanes& to) {
  Lanes square = radius;
  to.fill(1);
  for (; m > 0; m /= 2) {
    for (std::size_t i = 0; i < block_size; ++i) {
      if (m % 2 == 1) to[i] *= square[i];
      square[i] *= square[i];
    }
  }
}

// Whether all Y_lm up to the degree are negligible on circles of at most this radius (Reinecke and Seljebotn 2013).
bool negligible(std::uint32_t m, std::uint32_t degree, double radius) {
  return static_cast<double>(m) > radius * degree + std::max(100.0, 0.01 * degree);
}

// Runs body(task, slot) for each task, slot < wave.
template <class Body>
void run(std::size_t count, const char* phase, const base::Host& host, const Body& body) {
  for (std::size_t begin = 0; begin < count; begin += wave) {
    host.report(phase, begin, count);
    host.parallel_for(std::min(wave, count - begin), [&](std::size_t k) { body(begin + k, k); });
  }
}

}  // namespace

ScatteredTransform::ScatteredTransform(std::span<const Vector3> unit, std::uint32_t degree, const char* phase,
                                       const base::Host& host)
    : phase_(phase),
      host_(host),
      table_(degree, host.memory),
      circle_transform_(FourierTransform::fitting_length(2 * std::size_t{degree} + 2), host.memory),
      row_transform_(oversampled(degree), host.memory),
      column_transform_(oversampled(degree), host.memory),
      row_count_(row_transform_.length() / 2 + 1),
      width_(static_cast<std::ptrdiff_t>(column_transform_.length()) + 2 * pad),
      height_(host.memory),
      radius_(host.memory),
      row_factor_(degree + std::size_t{1}, host.memory),
      column_factor_(degree + std::size_t{1}, host.memory),
      orders_((degree / fourier_lanes + 1) * row_count_, host.memory),
      grid_((row_count_ + 2 * pad) * static_cast<std::size_t>(width_), host.memory),
      work_(2 * wave * std::max(row_transform_.length(), circle_transform_.length()), host.memory),
      points_(host.memory),
      band_start_(host.memory) {
  const std::size_t half = circle_transform_.length() / 2, blocks = half / block_size + 1;
  height_.resize(blocks);
  radius_.resize(blocks);
  for (std::size_t j = 0; j < blocks * block_size; ++j) {
    const auto angle = [half](std::size_t k) {
      return std::numbers::pi * static_cast<double>(k) / static_cast<double>(half);
    };
    const bool there = j <= half;
    height_[j / block_size][j % block_size] = there ? std::cos(angle(j)) : 1;
    radius_[j / block_size][j % block_size] = there ? std::sin(angle(std::min(j, half - j))) : 0;
  }
  for (std::size_t k = 0; k <= degree; ++k) {
    const double frequency = static_cast<double>(k);
    row_factor_[k] = 1 / (kernel_.transform(frequency / static_cast<double>(row_transform_.length())) *
                          static_cast<double>(circle_transform_.length()));
    column_factor_[k] = 1 / kernel_.transform(frequency / static_cast<double>(column_transform_.length()));
  }
  sort_points(unit);
}

bool ScatteredTransform::pays(std::size_t directions, std::uint32_t degree) {
  constexpr std::uint32_t min_degree = 80;
  // Nanoseconds of one core: of a basis function at a point, of a point on the grid, of an entry of the grid.
  constexpr double of_function = 0.42, of_point = 400, of_entry = 30;
  const double n = static_cast<double>(directions), size = degree + 1.0, functions = size * (size + 1) / 2;
  const double fast = n * of_point + size * functions * of_function + 8 * size * size * of_entry;
  return degree >= min_degree && n * functions * of_function > 2 * fast;
}

void ScatteredTransform::synthesise(const Coefficients& coefficients, std::size_t channel, std::span<double> values) {
  PackedCoefficients packed(table_, 1, host_.memory);
  packed.pack(coefficients.values, coefficients.degree, coefficients.channels, channel);
  transform_orders(Way::synthesis, packed);
  transform_rows(Way::synthesis);
  pad_grid();
  interpolate(coefficients.channels, channel, values);
}

void ScatteredTransform::analyse(std::span<const double> weights, std::span<const double> values, std::size_t channel,
                                 Coefficients& coefficients) {
  spread(weights, values, coefficients.channels, channel);
  fold_grid();
  transform_rows(Way::analysis);
  PackedCoefficients packed(table_, 1, host_.memory);
  transform_orders(Way::analysis, packed);
  packed.unpack(coefficients.values, coefficients.degree, coefficients.channels, channel);
}

void ScatteredTransform::transform_orders(Way way, PackedCoefficients& packed) {
  run(table_.degree() / fourier_lanes + 1, phase_, host_, [&](std::size_t group, std::size_t slot) {
    transform_order_group(way, static_cast<std::uint32_t>(group * fourier_lanes), packed, work(slot));
  });
}

// Between the coefficients of orders first, first + 1, ... and their values on the oversampled circles.
void ScatteredTransform::transform_order_group(Way way, std::uint32_t first, PackedCoefficients& packed,
                                               ComplexLanes* data) {
  const std::size_t circles = circle_transform_.length(), rows = row_transform_.length(), degree = table_.degree();
  ComplexLanes* scratch = data + std::max(circles, rows);
  ComplexLanes* values = orders_.data() + first / fourier_lanes * row_count_;
  const auto last = static_cast<std::uint32_t>(std::min<std::size_t>(first + fourier_lanes, degree + 1));
  // The factors that undo the kernel, from a series of one length to that of the other.
  const auto resize = [&](std::size_t from, std::size_t to) {
    std::copy_n(data, from, scratch);
    std::fill_n(data, to, ComplexLanes{});
    for (std::size_t k = 0; k <= degree; ++k) {
      for (std::size_t i = 0; i < fourier_lanes; ++i) {
        data[k].real[i] = scratch[k].real[i] * row_factor_[k];
        data[k].imaginary[i] = scratch[k].imaginary[i] * row_factor_[k];
        if (k == 0) continue;
        data[to - k].real[i] = scratch[from - k].real[i] * row_factor_[k];
        data[to - k].imaginary[i] = scratch[from - k].imaginary[i] * row_factor_[k];
      }
    }
  };
  if (way == Way::synthesis) {
    std::fill_n(data, circles, ComplexLanes{});
    for (std::uint32_t m = first; m < last; ++m)
      circles_of_order(m, m - first, packed, data);
    circle_transform_.transform(-1, data, scratch);
    resize(circles, rows);
    row_transform_.transform(1, data, scratch);
    std::copy_n(data, row_count_, values);
    return;
  }
  std::copy_n(values, row_count_, data);
  std::fill_n(data + row_count_, rows - row_count_, ComplexLanes{});
  row_transform_.transform(1, data, scratch);
  resize(rows, circles);
  circle_transform_.transform(-1, data, scratch);
  for (std::uint32_t m = first; m < last; ++m)
    order_of_circles(m, m - first, data, packed);
}

// Writes c_m - i s_m of theta from 0 to 2 pi to a lane.
void ScatteredTransform::circles_of_order(std::uint32_t m, std::size_t lane, const PackedCoefficients& packed,
                                          ComplexLanes* circles) const {
  const std::size_t length = circle_transform_.length(), half = length / 2;
  const double parity = m % 2 == 0 ? 1 : -1;
  GroupLanes cosine, sine;
  Lanes factor;
  for (std::size_t b = 0; b < height_.size(); ++b) {
    if (negligible(m, table_.degree(), *std::max_element(radius_[b].begin(), radius_[b].end()))) continue;
    power(radius_[b], m, factor);
    table_.synthesise(m, height_[b], 1, packed.order(m), cosine, sine);
    for (std::size_t i = 0; i < block_size && b * block_size + i <= half; ++i) {
      if (factor[i] == 0) continue;
      const std::size_t j = b * block_size + i;
      const double real = cosine[0][i] * factor[i], imaginary = -sine[0][i] * factor[i];
      circles[j].real[lane] = real;
      circles[j].imaginary[lane] = imaginary;
      if (j == 0 || j == half) continue;
      circles[length - j].real[lane] = parity * real;
      circles[length - j].imaginary[lane] = parity * imaginary;
    }
  }
}

// The transpose: adds to the coefficients.
void ScatteredTransform::order_of_circles(std::uint32_t m, std::size_t lane, const ComplexLanes* circles,
                                          PackedCoefficients& packed) const {
  const std::size_t length = circle_transform_.length(), half = length / 2;
  const double parity = m % 2 == 0 ? 1 : -1;
  GroupLanes cosine, sine;
  Lanes factor;
  for (std::size_t b = 0; b < height_.size(); ++b) {
    if (negligible(m, table_.degree(), *std::max_element(radius_[b].begin(), radius_[b].end()))) continue;
    power(radius_[b], m, factor);
    cosine[0].fill(0);
    sine[0].fill(0);
    for (std::size_t i = 0; i < block_size && b * block_size + i <= half; ++i) {
      const std::size_t j = b * block_size + i;
      double real = circles[j].real[lane], imaginary = circles[j].imaginary[lane];
      if (j > 0 && j < half) {
        real += parity * circles[length - j].real[lane];
        imaginary += parity * circles[length - j].imaginary[lane];
      }
      cosine[0][i] = real * factor[i];
      sine[0][i] = -imaginary * factor[i];
    }
    table_.analyse(m, height_[b], 1, cosine, sine, packed.order(m));
  }
}

void ScatteredTransform::transform_rows(Way way) {
  constexpr std::size_t rows_at_once = 2 * fourier_lanes;
  run((row_count_ + rows_at_once - 1) / rows_at_once, phase_, host_, [&](std::size_t group, std::size_t slot) {
    ComplexLanes* data = work(slot);
    ComplexLanes* scratch = data + std::max(circle_transform_.length(), row_transform_.length());
    if (way == Way::synthesis) {
      rows_of_orders(group * rows_at_once, data);
      column_transform_.transform(1, data, scratch);
      write_rows(group * rows_at_once, data);
    } else {
      read_rows(group * rows_at_once, data);
      column_transform_.transform(-1, data, scratch);
      orders_of_rows(group * rows_at_once, data);
    }
  });
}

// Writes the series in phi of the rows from `first`: a lane has one row as its real part and the next as its imaginary
// part.
void ScatteredTransform::rows_of_orders(std::size_t first, ComplexLanes* data) const {
  const std::size_t length = column_transform_.length();
  std::fill_n(data, length, ComplexLanes{});
  for (std::size_t m = 0; m <= table_.degree(); ++m) {
    const ComplexLanes* values = orders_.data() + m / fourier_lanes * row_count_;
    const std::size_t lane = m % fourier_lanes;
    const double factor = m > 0 ? 0.5 * column_factor_[m] : column_factor_[m];
    for (std::size_t i = 0; i < fourier_lanes && first + 2 * i < row_count_; ++i) {
      const bool two = first + 2 * i + 1 < row_count_;
      const ComplexLanes &one = values[first + 2 * i], &next = values[first + 2 * i + (two ? 1 : 0)];
      const double a = one.real[lane] * factor, b = one.imaginary[lane] * factor;
      const double c = two ? next.real[lane] * factor : 0, d = two ? next.imaginary[lane] * factor : 0;
      data[m].real[i] = a - d;
      data[m].imaginary[i] = b + c;
      if (m == 0) continue;
      data[length - m].real[i] = a + d;
      data[length - m].imaginary[i] = c - b;
    }
  }
}

// The transpose.
void ScatteredTransform::orders_of_rows(std::size_t first, const ComplexLanes* data) {
  const std::size_t length = column_transform_.length();
  for (std::size_t m = 0; m <= table_.degree(); ++m) {
    ComplexLanes* values = orders_.data() + m / fourier_lanes * row_count_;
    const std::size_t lane = m % fourier_lanes, opposite = m > 0 ? length - m : 0;
    const double factor = 0.5 * column_factor_[m];
    for (std::size_t i = 0; i < fourier_lanes && first + 2 * i < row_count_; ++i) {
      const double real = data[m].real[i], imaginary = data[m].imaginary[i];
      const double other_real = data[opposite].real[i], other_imaginary = data[opposite].imaginary[i];
      ComplexLanes* to = values + first + 2 * i;
      to[0].real[lane] = factor * (real + other_real);
      to[0].imaginary[lane] = factor * (imaginary - other_imaginary);
      if (first + 2 * i + 1 >= row_count_) continue;
      to[1].real[lane] = factor * (imaginary + other_imaginary);
      to[1].imaginary[lane] = factor * (other_real - real);
    }
  }
}

}  // namespace orbicube::harmonics
