#include "harmonics/scattered/order_series.h"

#include <algorithm>
#include <numbers>

namespace orbicube::harmonics {

OrderSeries::Work::Work(std::uint32_t degree, std::size_t pairs, std::size_t series, std::pmr::memory_resource* memory)
    : recurrence(degree, memory),
      coefficients(2 * orders_at_once * (degree + std::size_t{1}), memory),
      packed(2 * (degree + std::size_t{1}), memory),
      lanes(2 * circle_group * (degree + std::size_t{1}), memory),
      sums(4 * pairs, memory),
      power_rest(pairs, memory),
      powers((orders_at_once / 2 + 1) * pairs, memory),
      one(series, memory),
      other(series, memory) {}

CircleSums OrderSeries::Work::circle_sums() {
  const std::size_t n = power_rest.size();
  return {sums.data(), sums.data() + n, sums.data() + 2 * n, sums.data() + 3 * n};
}

OrderSeries::OrderSeries(std::uint32_t degree, std::size_t rows, const SpreadingKernel& kernel, const base::Host& host)
    : host_(host),
      degree_(degree),
      circle_transform_(FourierTransform::fitting_length(2 * std::size_t{degree} + 2), host.memory),
      row_transform_(rows, host.memory),
      pairs_(circle_transform_.length() / 4 + 1, host.memory),
      factor_(degree + std::size_t{1}, host.memory),
      slots_(host),
      work_(host.memory) {
  const std::size_t half = circle_transform_.length() / 2;
  for (std::size_t p = 0; p < pairs_.size(); ++p)
    pairs_.set(p, std::numbers::pi_v<long double> * static_cast<long double>(p) / static_cast<long double>(half));
  for (std::size_t k = 0; k <= degree; ++k) {
    const double frequency = static_cast<double>(k) / static_cast<double>(rows);
    factor_[k] = 0.5 / (kernel.transform(frequency) * static_cast<double>(circle_transform_.length()));
  }
  const std::size_t longest = std::max(rows, circle_transform_.length());
  work_.reserve(slots_.count());
  for (std::size_t k = 0; k < slots_.count(); ++k)
    work_.emplace_back(degree, pairs_.padded(), longest, host.memory);
}

void OrderSeries::synthesise(const Coefficients& coefficients, std::size_t channel, const char* phase,
                             OrderRows& rows) {
  const std::size_t length = row_transform_.length();
  slots_.run_all(rows.group_count, phase, host_, [&](std::size_t group, std::size_t slot) {
    Work& work = work_[slot];
    const auto first = static_cast<std::uint32_t>(group * orders_at_once);
    read_coefficients(coefficients, channel, first, work);
    std::fill_n(work.one.begin(), circle_transform_.length(), ComplexLanes{});
    for (std::uint32_t m = first; m <= std::min(degree_, first + std::uint32_t{orders_at_once} - 1); ++m)
      circles_of_order(work, m);
    const ComplexLanes* spectrum = circle_transform_.transform(-1, work.one.data(), work.other.data());
    ComplexLanes* free = spectrum == work.one.data() ? work.other.data() : work.one.data();
    resize(spectrum, circle_transform_.length(), free, length);
    ComplexLanes* scratch = spectrum == work.one.data() ? work.one.data() : work.other.data();
    const ComplexLanes* series = row_transform_.transform(1, free, scratch);
    ComplexLanes* to = rows.at(group, 0);
    for (std::size_t r = 0; r < rows.row_count; ++r, to += 2) {
      const ComplexLanes &a = series[r], &b = series[r > 0 ? length - r : 0];
      for (std::size_t i = 0; i < fourier_lanes; ++i) {
        to[0].real[i] = a.real[i] + b.real[i];
        to[0].imaginary[i] = a.imaginary[i] + b.imaginary[i];
        to[1].real[i] = a.real[i] - b.real[i];
        to[1].imaginary[i] = a.imaginary[i] - b.imaginary[i];
      }
    }
  });
}

void OrderSeries::analyse(const OrderRows& rows, std::size_t channel, const char* phase, Coefficients& coefficients) {
  const std::size_t length = row_transform_.length();
  slots_.run_all(rows.group_count, phase, host_, [&](std::size_t group, std::size_t slot) {
    Work& work = work_[slot];
    const auto first = static_cast<std::uint32_t>(group * orders_at_once);
    const ComplexLanes* from = rows.at(group, 0);
    for (std::size_t r = 0; r < rows.row_count; ++r, from += 2) {
      ComplexLanes &a = work.one[r], &b = work.one[r > 0 ? length - r : 0];
      const double twice = 2 * r == length || r == 0 ? 2 : 1;
      for (std::size_t i = 0; i < fourier_lanes; ++i) {
        b.real[i] = twice * from[0].real[i] - (twice == 1 ? from[1].real[i] : 0);
        b.imaginary[i] = twice * from[0].imaginary[i] - (twice == 1 ? from[1].imaginary[i] : 0);
        if (twice == 1) {
          a.real[i] = from[0].real[i] + from[1].real[i];
          a.imaginary[i] = from[0].imaginary[i] + from[1].imaginary[i];
        }
      }
    }
    const ComplexLanes* spectrum = row_transform_.transform(1, work.one.data(), work.other.data());
    const bool in_one = spectrum == work.one.data();
    ComplexLanes *free = in_one ? work.other.data() : work.one.data(),
                 *scratch = in_one ? work.one.data() : work.other.data();
    resize(spectrum, length, free, circle_transform_.length());
    const ComplexLanes* circles = circle_transform_.transform(-1, free, scratch);
    for (std::uint32_t m = first; m <= std::min(degree_, first + std::uint32_t{orders_at_once} - 1); ++m)
      order_of_circles(work, m, circles);
    write_coefficients(work, channel, first, coefficients);
  });
}

void OrderSeries::read_coefficients(const Coefficients& coefficients, std::size_t channel, std::uint32_t first,
                                    Work& work) const {
  const std::size_t stride = 2 * (degree_ + std::size_t{1});
  for (std::uint32_t l = first; l <= degree_; ++l) {
    const double* middle = &coefficients.values[basis_index(l, 0) * coefficients.channels + channel];
    const std::uint32_t last = std::min(l, first + std::uint32_t{orders_at_once} - 1);
    for (std::uint32_t m = first; m <= last; ++m) {
      double* to = &work.coefficients[(m - first) * stride + 2 * (l - m)];
      const auto offset = static_cast<std::ptrdiff_t>(m * coefficients.channels);
      to[0] = middle[offset];
      to[1] = m > 0 ? middle[-offset] : 0;
    }
  }
}

void OrderSeries::write_coefficients(const Work& work, std::size_t channel, std::uint32_t first,
                                     Coefficients& coefficients) const {
  const std::size_t stride = 2 * (degree_ + std::size_t{1});
  for (std::uint32_t l = first; l <= degree_; ++l) {
    double* middle = &coefficients.values[basis_index(l, 0) * coefficients.channels + channel];
    const std::uint32_t last = std::min(l, first + std::uint32_t{orders_at_once} - 1);
    for (std::uint32_t m = first; m <= last; ++m) {
      const double* from = &work.coefficients[(m - first) * stride + 2 * (l - m)];
      const auto offset = static_cast<std::ptrdiff_t>(m * coefficients.channels);
      middle[offset] = from[0];
      if (m > 0) middle[-offset] = from[1];
    }
  }
}

// Orders of a group come one after the other.
OrderSeries::OnCircles OrderSeries::begin_order(Work& work, std::uint32_t m) const {
  if (m % orders_at_once == 0)
    pairs_.powers(m / 2, orders_at_once / 2 + 1, pairs_.first_pair(m, degree_), work.powers.data(),
                  work.power_rest.data());
  work.recurrence.set_order(m);
  const std::size_t length = circle_transform_.length();
  return {length,
          length / 2,
          m % orders_at_once / 2,
          m % 2 == 0 ? 1.0 : -1.0,
          power(work, m, m / 2),
          power(work, m, m - m / 2),
          pairs_.first_pair(m, degree_)};
}

// radius^half, of an order of the group.
const double* OrderSeries::power(const Work& work, std::uint32_t m, std::uint32_t half) const {
  return work.powers.data() + (half - m / orders_at_once * (orders_at_once / 2)) * pairs_.padded();
}

// Adds c_m - i s_m of theta from 0 to 2 pi to the lane of an order.
void OrderSeries::circles_of_order(Work& work, std::uint32_t m) const {
  const OnCircles on = begin_order(work, m);
  const std::size_t length = on.length, half = on.half, lane = on.lane;
  const double parity = on.parity;
  const double* from = &work.coefficients[m % orders_at_once * 2 * (degree_ + std::size_t{1})];
  for (std::size_t l = 0; l < work.recurrence.count(); ++l) {
    work.packed[2 * l] = from[2 * l] * work.recurrence.scales()[l];
    work.packed[2 * l + 1] = from[2 * l + 1] * work.recurrence.scales()[l];
  }
  const CircleSums sums = work.circle_sums();
  pairs_.synthesise(work.recurrence, work.packed.data(), on.start, on.first, sums);
  const auto add = [&](std::size_t j, double real, double imaginary) {
    work.one[j].real[lane] += real;
    work.one[j].imaginary[lane] += imaginary;
    if (j == 0 || j == half) return;
    work.one[length - j].real[lane] += parity * real;
    work.one[length - j].imaginary[lane] += parity * imaginary;
  };
  for (std::size_t p = on.first; p < pairs_.size(); ++p) {
    const double factor = on.end[p];
    if (factor == 0) continue;
    const double even_real = sums.even_cosine[p] * factor, even_imaginary = -sums.even_sine[p] * factor;
    const double odd_real = sums.odd_cosine[p] * factor, odd_imaginary = -sums.odd_sine[p] * factor;
    add(p, even_real + odd_real, even_imaginary + odd_imaginary);
    if (2 * p != half) add(half - p, even_real - odd_real, even_imaginary - odd_imaginary);
  }
}

// The transpose: writes the coefficients of an order.
void OrderSeries::order_of_circles(Work& work, std::uint32_t m, const ComplexLanes* circles) const {
  const OnCircles on = begin_order(work, m);
  const std::size_t length = on.length, half = on.half, lane = on.lane;
  const double parity = on.parity;
  const CircleSums sums = work.circle_sums();
  std::fill(work.sums.begin(), work.sums.end(), 0.0);
  const auto at = [&](std::size_t j, double factor) {
    const ComplexLanes &one = circles[j], &other = circles[j > 0 ? length - j : 0];
    if (j == 0 || j == half) return std::array<double, 2>{factor * one.real[lane], factor * one.imaginary[lane]};
    return std::array<double, 2>{factor * (one.real[lane] + parity * other.real[lane]),
                                 factor * (one.imaginary[lane] + parity * other.imaginary[lane])};
  };
  for (std::size_t p = on.first; p < pairs_.size(); ++p) {
    const double factor = on.end[p];
    const std::array<double, 2> north = at(p, factor);
    const std::array<double, 2> south = 2 * p != half ? at(half - p, factor) : std::array<double, 2>{};
    sums.even_cosine[p] = north[0] + south[0];
    sums.even_sine[p] = -(north[1] + south[1]);
    if (2 * p == half) continue;
    sums.odd_cosine[p] = north[0] - south[0];
    sums.odd_sine[p] = -(north[1] - south[1]);
  }
  pairs_.analyse(work.recurrence, sums, on.start, on.first, work.lanes.data(), work.packed.data());
  double* to = &work.coefficients[m % orders_at_once * 2 * (degree_ + std::size_t{1})];
  for (std::size_t l = 0; l < work.recurrence.count(); ++l) {
    to[2 * l] = work.packed[2 * l] * work.recurrence.scales()[l];
    to[2 * l + 1] = work.packed[2 * l + 1] * work.recurrence.scales()[l];
  }
}

// From a spectrum of one length to one of another, with the factors.
ComplexLanes* OrderSeries::resize(const ComplexLanes* from, std::size_t length, ComplexLanes* to,
                                  std::size_t to_length) const {
  const auto copy = [&](std::size_t a, std::size_t b, double factor) {
    for (std::size_t i = 0; i < fourier_lanes; ++i) {
      to[b].real[i] = factor * from[a].real[i];
      to[b].imaginary[i] = factor * from[a].imaginary[i];
    }
  };
  copy(0, 0, factor_[0]);
  for (std::size_t k = 1; k <= degree_; ++k) {
    copy(k, k, factor_[k]);
    copy(length - k, to_length - k, factor_[k]);
  }
  std::fill(to + degree_ + 1, to + (to_length - degree_), ComplexLanes{});
  return to;
}

}  // namespace orbicube::harmonics
